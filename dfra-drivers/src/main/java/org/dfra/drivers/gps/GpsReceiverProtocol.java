package org.dfra.drivers.gps;

import java.io.IOException;
import java.util.List;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.link.SerialLink;
import org.dfra.persona.GpsReceiverAttributes;

/**
 * The protocol of one type of receiver: how to parse its bytes, and what to send to it. Everything
 * else is in {@link GpsReceiverImpl}. The reader thread calls all methods; they must not block.
 */
public interface GpsReceiverProtocol {

  /** Receives what the receiver reports; on the reader thread. */
  interface Listener {

    /** A solution, with a position or without. */
    void solutionReceived(GpsSolution solution);

    /** The satellites in view. */
    void satellitesReceived(List<SatelliteInView> satellites);

    /** The receiver's identity; reported again when more is known. */
    void identityReceived(GpsReceiverAttributes receiver);

    /** An intact message of this name has been received; for threads that wait for it. */
    void messageReceived(String name);

    /**
     * An intact message with an invalid value; the first on a link is logged as a warning.
     *
     * @param name the message's name
     * @param reason which value, what it is, and which values are valid
     */
    void malformedReceived(String name, String reason);

    /** A warning for the operator, as a sentence; it is logged. */
    void warn(String sentence);
  }

  /**
   * The link has been opened: resets the protocol's state and sends the initial commands.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /** Parses the received bytes and passes the messages to the listener; always the same parser. */
  FrameParser<?> parser();

  /**
   * Called after every read, with or without bytes: sends what is due.
   *
   * @throws IOException if the link is lost
   */
  default void periodic(SerialLink link) throws IOException {}
}
