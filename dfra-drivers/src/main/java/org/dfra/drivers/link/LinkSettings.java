package org.dfra.drivers.link;

import java.time.Duration;
import org.dfra.core.config.Parameters;
import org.dfra.drivers.link.LinkKeeper.BackOff;

/** Reads the common parameters of the drivers of devices behind a link. */
public final class LinkSettings {

  private LinkSettings() {}

  /**
   * {@code link}: the device's address; required.
   *
   * @throws org.dfra.core.config.ConfigurationException if it is not set or is not a link URL
   */
  public static LinkAddress address(Parameters parameters) {
    try {
      return LinkAddress.parse(parameters.text("link"));
    } catch (IllegalArgumentException e) {
      throw parameters.fault("link", "a usable link: " + e.getMessage(), e);
    }
  }

  /**
   * {@code reopen_initial_delay}, {@code reopen_max_delay}: initial and maximum wait before a lost
   * link is reopened, seconds, 0.01 to 3600; default 0.5 and 8.
   *
   * @throws org.dfra.core.config.ConfigurationException if they are set to anything else
   */
  public static BackOff backOff(Parameters parameters) {
    Duration shortest = Duration.ofMillis(10);
    Duration hour = Duration.ofHours(1);
    Duration first =
        parameters.seconds("reopen_initial_delay", Duration.ofMillis(500), shortest, hour);
    Duration longest =
        parameters.seconds("reopen_max_delay", Duration.ofSeconds(8), shortest, hour);
    if (longest.compareTo(first) < 0) {
      String set =
          parameters.find("reopen_max_delay").isPresent()
              ? "reopen_max_delay"
              : "reopen_initial_delay";
      throw parameters.fault(
          set,
          "in order: reopen_initial_delay is "
              + first.toMillis() / 1e3
              + " s and reopen_max_delay "
              + longest.toMillis() / 1e3
              + " s, but it must be at least as long",
          null);
    }
    return new BackOff(first, longest);
  }
}
