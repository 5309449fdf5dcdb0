package org.dfra.drivers.device;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Supplier;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.link.EventCounter;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkDiagnostics;
import org.dfra.drivers.link.LinkHandler;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * A link to a device, kept open and judged by whether the device gives signs of life.
 *
 * <p>Parameters that it reads: {@code link}, {@code reopen_first} and {@code reopen_longest}, see
 * {@link LinkSettings}. Parameters that it shows, by {@link #declareIn}: {@code frames}, {@code
 * dropped_bytes}, {@code malformed_frames}. Tests: {@code link}, {@code readings}; recovery: {@code
 * reopen_link}.
 *
 * <p>Threads: one reader ({@code name reader}), owned from {@link #start} to {@link #close}, calls
 * the protocol. {@link #send} and what is asked may be called by any thread.
 */
public final class DeviceLink implements AutoCloseable {

  private static final String LIFE = "sign of life";

  private final DeviceProtocol protocol;
  private final Ticker ticker;
  private final LinkKeeper keeper;
  private final EventCounter eventCounter;
  private final LinkDiagnostics examination;

  /** What others want to be sent; sent by the reader, which alone has the link. */
  private final ConcurrentLinkedQueue<byte[]> outbox = new ConcurrentLinkedQueue<>();

  private volatile @Nullable SerialLink link;
  private volatile StreamCounts counts = StreamCounts.ZERO;
  private long lifeNanos; // confined to the reader

  /**
   * @param context what the driver was given
   * @param protocol what is particular to the device
   * @param ticker the time to wait by
   * @param source opens the link; null to go by the parameter {@code link}
   * @param log where the link's changes are told
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public DeviceLink(
      ModuleContext context,
      DeviceProtocol protocol,
      Ticker ticker,
      LinkKeeper.@Nullable Source source,
      Logger log) {
    LinkAddress address = LinkSettings.address(context.parameters());
    this.protocol = protocol;
    this.ticker = ticker;
    this.eventCounter = new EventCounter(ticker);
    this.keeper =
        new LinkKeeper(
            context.name(),
            source == null ? () -> address.open(ticker) : source,
            new Dialogue(),
            LinkSettings.backOff(context.parameters()),
            ticker,
            log);
    this.examination = new LinkDiagnostics(keeper, eventCounter);
  }

  /** Declares what every device behind a link has, see above. */
  public void declareIn(Diagnostics examinations, ParameterTable table) {
    examinations.addTest("link", this::link);
    examinations.addTest("readings", this::life);
    examinations.addRecovery("reopen_link", this::reopenLink);
    showCounts(table, () -> counts);
  }

  /** Declares {@code frames}, {@code dropped_bytes} and {@code malformed_frames}, to be read. */
  public static void showCounts(ParameterTable table, Supplier<StreamCounts> counts) {
    table.declareReadOnly(
        "frames", "intact frames so far", () -> Long.toString(counts.get().frames()));
    table.declareReadOnly(
        "dropped_bytes",
        "bytes that belonged to no frame so far",
        () -> Long.toString(counts.get().droppedBytes()));
    table.declareReadOnly(
        "malformed_frames",
        "intact frames with values that cannot be so far",
        () -> Long.toString(counts.get().malformed()));
  }

  /** Begins to open the link; does nothing when already begun. */
  public void start() {
    keeper.start();
  }

  /** Closes the link for good and returns when nothing more will be told. */
  @Override
  public void close() {
    keeper.close();
  }

  /**
   * Has bytes sent soon; from any thread. Forgotten when the link is opened anew before. At the
   * latest they are sent when the reader next wakes, that is within 0.1 s; for less see {@link
   * #sendNow}.
   */
  public void send(byte[] bytes) {
    outbox.add(bytes);
  }

  /**
   * Hands bytes to the line at once; from any thread. Whole messages are never mixed.
   *
   * @return false if there is no link, or it was lost just now; nothing is sent later then
   */
  public boolean sendNow(byte[] bytes) {
    @Nullable SerialLink now = link;
    if (now == null) {
      return false;
    }
    try {
      now.write(bytes);
      return true;
    } catch (IOException e) {
      return false; // the reader finds out too, and tells why
    }
  }

  /** The device has shown that it lives and works; on the reader thread. */
  public void reportAlive() {
    lifeNanos = ticker.nanos();
    eventCounter.increment(LIFE);
  }

  /** What the device has said, for those who wait for it. */
  public EventCounter eventCounter() {
    return eventCounter;
  }

  /** What has come over the link since the start, all openings together. */
  public StreamCounts counts() {
    return counts;
  }

  /** Whether the link is open. */
  public boolean isOpen() {
    return keeper.isOpen();
  }

  /** Has the link closed and opened again. */
  public void reopen() {
    keeper.reopen();
  }

  /** Whether the link is open, as a finding. */
  public DiagnosticFinding link() {
    return examination.link();
  }

  private DiagnosticFinding life() throws InterruptedException {
    DiagnosticFinding link = link();
    return link.passed() ? nextLife("the device speaks") : link;
  }

  private DiagnosticFinding nextLife(String good) throws InterruptedException {
    Duration patience = protocol.livenessTimeout();
    return eventCounter.await(LIFE, eventCounter.total(LIFE), patience)
        ? new DiagnosticFinding(true, good)
        : new DiagnosticFinding(
            false,
            "no " + protocol.expected() + " has come within " + LatestReading.seconds(patience));
  }

  /** Has the link opened anew and waits for a sign of life, as a finding. */
  public DiagnosticFinding reopenLink() throws InterruptedException {
    return examination.reopen("device", this::nextLife);
  }

  /** What happens from one opening of the link to the next; on the reader thread. */
  private final class Dialogue implements LinkHandler {

    @Override
    public void opened(SerialLink opened) throws IOException {
      lifeNanos = ticker.nanos();
      outbox.clear();
      protocol.opened(opened);
      link = opened;
      examination.opened();
    }

    @Override
    public boolean received(byte[] bytes, int length) {
      StreamCounts before = protocol.parser().counts();
      protocol.parser().feed(bytes, 0, length);
      StreamCounts now = protocol.parser().counts();
      counts = now;
      return now.frames() - now.malformed() > before.frames() - before.malformed();
    }

    @Override
    public @Nullable String periodic(SerialLink open) throws IOException {
      for (byte[] bytes = outbox.poll(); bytes != null; bytes = outbox.poll()) {
        open.write(bytes);
      }
      protocol.periodic(open);
      Duration longest = protocol.livenessTimeout();
      return ticker.nanos() - lifeNanos > longest.toNanos()
          ? "no " + protocol.expected() + " for " + LatestReading.seconds(longest)
          : null;
    }

    @Override
    public Duration pollInterval() {
      return protocol.pollInterval();
    }

    @Override
    public void lost(String reason) {
      link = null;
      protocol.parser().finish();
      counts = protocol.parser().counts();
      protocol.lost(reason);
    }
  }
}
