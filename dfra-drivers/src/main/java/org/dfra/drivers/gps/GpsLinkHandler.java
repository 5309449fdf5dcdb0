package org.dfra.drivers.gps;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.link.LinkHandler;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GpsFix;
import org.jspecify.annotations.Nullable;

/**
 * What happens between the driver and its receiver from one opening of the link to the next, for
 * every protocol: it judges whether the receiver is alive and whether its positions are.
 *
 * <p>Confined to the reader thread, but for {@link #send}.
 */
final class GpsLinkHandler implements LinkHandler {

  /** Is told what becomes of the link; on the reader thread. */
  interface Listener {

    /** The link is open. */
    void opened();

    /** Bytes have come. */
    void countsChanged(StreamCounts counts);

    /**
     * The last position is too old to be served, or there is no device to serve one.
     *
     * @param awaits what is missing, as a clause
     */
    void positionLost(String awaits);
  }

  private final GpsReceiverProtocol protocol;
  private final ReportingPeriod pace;
  private final Ticker ticker;
  private final Listener listener;

  /** What others want to be sent; sent by the reader, which alone has the link. */
  private final ConcurrentLinkedQueue<byte[]> outbox = new ConcurrentLinkedQueue<>();

  private long solvedNanos;
  private long positionNanos;
  private String state = "";

  /**
   * @param pace how often positions are expected, and how long without one the receiver is taken
   *     for lost
   */
  GpsLinkHandler(
      GpsReceiverProtocol protocol, ReportingPeriod pace, Ticker ticker, Listener listener) {
    this.protocol = protocol;
    this.pace = pace;
    this.ticker = ticker;
    this.listener = listener;
  }

  /** Has bytes sent soon; from any thread. Forgotten when the link is opened anew first. */
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
    Duration silence = pace.longestAge();
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

  /** A solution has come. */
  void solutionReceived(GpsSolution solution) {
    solvedNanos = ticker.nanos();
    pace.arrived();
    state = "the receiver has no position, it is " + solution.state();
    if (solution.fix().mode() != GpsFix.Mode.NONE) {
      positionNanos = solvedNanos;
    }
  }
}
