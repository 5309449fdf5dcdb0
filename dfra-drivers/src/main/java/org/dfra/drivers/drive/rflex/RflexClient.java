package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import org.dfra.drivers.device.SharedLinkClient;

/** A module that shares an {@link RflexController}. */
interface RflexClient extends SharedLinkClient {

  /** Default period of axis reports. */
  Duration USUAL_REPORTS = Duration.ofMillis(100);

  /** Default period of battery and brake reports. */
  Duration USUAL_STATUS = Duration.ofSeconds(1);

  /** Required period of axis reports; queried repeatedly. */
  default Duration reports() {
    return USUAL_REPORTS;
  }

  /** Required period of battery and brake reports; queried repeatedly. */
  default Duration status() {
    return USUAL_STATUS;
  }

  /** The link is open; from now on messages are received and commands can be sent. */
  void opened();

  /** The controller has sent this message. */
  void messageReceived(RflexMessage message);
}
