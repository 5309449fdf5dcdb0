package org.dfra.drivers.device;

import java.io.IOException;
import java.time.Duration;
import org.dfra.drivers.frame.StreamParser;
import org.dfra.drivers.link.SerialLink;

/**
 * What is particular to one device: its bytes, and what it must be told. All methods are called by
 * the line's reader thread and must not block.
 */
public interface DeviceProtocol {

  /**
   * The link has been opened: forgets the last one and sends what the device must be told first.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /** Takes the bytes that come; always the same. What they say is told to the driver from there. */
  StreamParser parser();

  /**
   * Called after every read, in vain or not: sends what is due by now.
   *
   * @throws IOException if the link is lost
   */
  default void periodic(SerialLink link) throws IOException {}

  /**
   * The longest wait for bytes before {@link #periodic} is called all the same, 0.1 s by default:
   * less where something has to be sent in time. Serial ports round it up to 0.1 s.
   */
  default Duration pollInterval() {
    return Duration.ofMillis(100);
  }

  /**
   * For how long the device may give no {@linkplain DeviceLink#reportAlive sign of life} before its
   * link is opened anew; as things are now, since a device that rests may be silent for longer.
   */
  Duration livenessTimeout();

  /** What it is silent about when it is, for people: {@code scan}, {@code report}. */
  String expected();

  /**
   * There is no device now; the link will be opened again after a while.
   *
   * @param reason why, as a clause
   */
  void lost(String reason);
}
