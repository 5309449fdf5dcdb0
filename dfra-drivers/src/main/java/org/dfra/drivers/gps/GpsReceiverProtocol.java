package org.dfra.drivers.gps;

import java.io.IOException;
import java.util.List;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.link.SerialLink;
import org.dfra.persona.GpsReceiverAttributes;

/**
 * What is particular to one kind of receiver: its bytes, and what it must be told. Everything else
 * is in {@link GpsReceiverImpl}. All methods are called by the reader thread and must not block.
 */
public interface GpsReceiverProtocol {

  /** Is told what the receiver says; on the reader thread. */
  interface Listener {

    /** A solution, with a position or without. */
    void solutionReceived(GpsSolution solution);

    /** The satellites that the receiver sees now. */
    void satellitesReceived(List<SatelliteInView> satellites);

    /** What the receiver is; told again when more is known. */
    void identityReceived(GpsReceiverAttributes receiver);

    /** An intact message of this name has come; for those who wait for it. */
    void messageReceived(String name);

    /**
     * An intact message that cannot be believed; the first of a link is logged as a warning.
     *
     * @param name the message's name
     * @param reason which value, what it is and what it may be
     */
    void malformedReceived(String name, String reason);

    /** Something that a person should know, a sentence; it is logged as a warning. */
    void warn(String sentence);
  }

  /**
   * The link has been opened: forgets the last one and says what the receiver must be told first.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /** Takes the bytes that come; always the same. It tells the listener what they say. */
  FrameParser<?> parser();

  /**
   * Called after every read, in vain or not: says what is due by now.
   *
   * @throws IOException if the link is lost
   */
  default void periodic(SerialLink link) throws IOException {}
}
