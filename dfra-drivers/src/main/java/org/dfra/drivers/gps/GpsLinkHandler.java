package org.dfra.drivers.gps;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.link.LinkHandler;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GpsFix;
import org.jspecify.annotations.Nullable;

/**
 * Handles the link to a receiver from one opening to the next, for every protocol: it monitors
 * whether the receiver is alive and whether its positions are current.
 *
 * <p>Confined to the reader thread, except {@link #send}.
 */
final class GpsLinkHandler implements LinkHandler {

  /** Receives the events of the link; on the reader thread. */
  interface Listener {

    /** The link is open. */
    void opened();

    /** Bytes have been received. */
    void countsChanged(StreamCounts counts);

    /**
     * The last position has expired, or the device is lost.
     *
     * @param awaits what is missing, as a clause
     */
    void positionLost(String awaits);
  }

  private final GpsReceiverProtocol protocol;
  private final ReportingPeriod reportingPeriod;
  private final Ticker ticker;
  private final Listener listener;

  /** Bytes from other threads, sent by the reader, which alone has the link. */
  private final ConcurrentLinkedQueue<byte[]> outbox = new ConcurrentLinkedQueue<>();

  private long solvedNanos;
  private long positionNanos;
  private String state = "";

  /**
   * @param reportingPeriod how often positions are expected, and after what time without one the
   *     receiver counts as lost
   */
  GpsLinkHandler(
      GpsReceiverProtocol protocol,
      ReportingPeriod reportingPeriod,
      Ticker ticker,
      Listener listener) {
    this.protocol = protocol;
    this.reportingPeriod = reportingPeriod;
    this.ticker = ticker;
    this.listener = listener;
  }

  /**
   * Queues bytes for sending; from any thread. They are discarded when the link is reopened first.
   */
  void send(byte[] bytes) {
    outbox.add(bytes);
  }

  @Override
  public void opened(SerialLink link) throws IOException {
    solvedNanos = ticker.nanos();
    positionNanos = solvedNanos;
    state = link + " is open, no position frame has come yet";
    listener.positionLost(state);
    outbox.clear();
    listener.opened();
    protocol.opened(link);
  }

  @Override
  public boolean received(byte[] bytes, int length) {
    long before = protocol.parser().counts().frames();
    protocol.parser().feed(bytes, 0, length);
    StreamCounts counts = protocol.parser().counts();
    listener.countsChanged(counts);
    return counts.frames() > before;
  }

  @Override
  public @Nullable String periodic(SerialLink link) throws IOException {
    for (byte[] bytes = outbox.poll(); bytes != null; bytes = outbox.poll()) {
      link.write(bytes);
    }
    protocol.periodic(link);
    long now = ticker.nanos();
    Duration silence = reportingPeriod.longestAge();
    if (now - solvedNanos > silence.toNanos()) {
      return "no position frame for " + LatestReading.seconds(silence);
    }
    if (now - positionNanos > silence.toNanos()) {
      listener.positionLost(state);
    }
    return null;
  }

  @Override
  public void lost(String reason) {
    protocol.parser().finish();
    listener.countsChanged(protocol.parser().counts());
    listener.positionLost(reason);
  }

  /** A solution has been received. */
  void solutionReceived(GpsSolution solution) {
    solvedNanos = ticker.nanos();
    reportingPeriod.arrived();
    state = "the receiver has no position, it is " + solution.state();
    if (solution.fix().mode() != GpsFix.Mode.NONE) {
      positionNanos = solvedNanos;
    }
  }
}
