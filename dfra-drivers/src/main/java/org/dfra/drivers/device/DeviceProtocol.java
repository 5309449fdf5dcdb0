package org.dfra.drivers.device;

import java.io.IOException;
import java.time.Duration;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.frame.StreamParser;
import org.dfra.drivers.link.SerialLink;

/**
 * The protocol of one device: how to parse its bytes, and what to send to it. The link's reader
 * thread calls all methods; they must not block.
 */
public interface DeviceProtocol {

  /**
   * The link has been opened: resets the protocol's state and sends the initial commands.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /** Parses the received bytes and passes the messages to the driver; always the same parser. */
  StreamParser parser();

  /**
   * Called after every read, with or without bytes: sends what is due.
   *
   * @throws IOException if the link is lost
   */
  default void periodic(SerialLink link) throws IOException {}

  /**
   * Maximum wait for bytes between calls of {@link #periodic}, 0.1 s by default; shorter where
   * messages must be sent on time. Serial ports round it up to 0.1 s.
   */
  default Duration pollInterval() {
    return Duration.ofMillis(100);
  }

  /**
   * How long the device may give no {@linkplain DeviceLink#reportAlive sign of life} before its
   * link is reopened, in the current state; an idle device may be silent for longer.
   */
  Duration livenessTimeout();

  /** Human-readable name of the expected message: {@code scan}, {@code report}. */
  String expected();

  /**
   * Why a silent device is lost, as a clause: no expected message for that long. A protocol
   * overrides it if it knows the reason for the silence.
   *
   * @param timeout the exceeded {@link #livenessTimeout}
   */
  default String silenceReason(Duration timeout) {
    return "no " + expected() + " for " + LatestReading.seconds(timeout);
  }

  /**
   * The device is lost; the link will be reopened after the back-off.
   *
   * @param reason why, as a clause
   */
  void lost(String reason);
}
