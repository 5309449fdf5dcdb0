package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import org.dfra.drivers.device.SharedLinkClient;

/** A module that shares an {@link RflexController}. */
interface RflexClient extends SharedLinkClient {

  /** How often it wants to hear where the axes are, unless it says otherwise. */
  Duration USUAL_REPORTS = Duration.ofMillis(100);

  /** How often it wants to hear of battery and brake, unless it says otherwise. */
  Duration USUAL_STATUS = Duration.ofSeconds(1);

  /** How often it wants to hear where the axes are; asked again and again. */
  default Duration reports() {
    return USUAL_REPORTS;
  }

  /** How often it wants to hear of battery and brake; asked again and again. */
  default Duration status() {
    return USUAL_STATUS;
  }

  /** The link is open; from now on it is heard, and can be told something. */
  void opened();

  /** The controller said this. */
  void messageReceived(RflexMessage message);
}
