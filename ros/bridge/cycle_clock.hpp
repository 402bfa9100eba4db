// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::bridge {

/// Decides when the next control cycle is due: `period` after the last one. With scans, a cycle
/// waits up to a tenth of the period longer for the next scan, or begins up to a tenth earlier when
/// one has come. So commands follow the scans of a lidar of the same rate without delay.
class CycleClock {
 public:
  explicit CycleClock(bool waits_for_scans) : waits_for_scans_(waits_for_scans) {}

  /// @param scan_came  a scan came just now; one that came earlier in the period does not count.
  [[nodiscard]] bool due(double now, double period, bool scan_came) const noexcept {
    const double since = now - last_;
    if (since < 0.0) return true;  // the clock was set back
    return since >= (waits_for_scans_ ? 1.1 : 1.0) * period || (scan_came && since >= 0.9 * period);
  }

  void begin(double now) noexcept { last_ = now; }

 private:
  bool waits_for_scans_;
  double last_ = 0.0;
};

}  // namespace fairway::bridge
