package org.dfra.drivers.gps;

import java.time.Duration;
import org.dfra.core.config.Parameters;
import org.dfra.drivers.link.BackOff;
import org.dfra.drivers.link.LinkAddress;

/** Reads the parameters that all receivers have. */
final class ReceiverSettings {

  private ReceiverSettings() {}

  static LinkAddress link(Parameters parameters) {
    try {
      return LinkAddress.parse(parameters.text("link"));
    } catch (IllegalArgumentException e) {
      throw parameters.fault("link", "a usable link: " + e.getMessage(), e);
    }
  }

  static BackOff backOff(Parameters parameters) {
    Duration shortest = Duration.ofMillis(10);
    Duration hour = Duration.ofHours(1);
    Duration first = parameters.seconds("reopen_first", Duration.ofMillis(500), shortest, hour);
    Duration longest = parameters.seconds("reopen_longest", Duration.ofSeconds(8), shortest, hour);
    if (longest.compareTo(first) < 0) {
      String set =
          parameters.find("reopen_longest").isPresent() ? "reopen_longest" : "reopen_first";
      throw parameters.fault(
          set,
          "in order: reopen_first is "
              + first.toMillis() / 1e3
              + " s and reopen_longest "
              + longest.toMillis() / 1e3
              + " s, but it must be at least as long",
          null);
    }
    return new BackOff(first, longest);
  }
}
