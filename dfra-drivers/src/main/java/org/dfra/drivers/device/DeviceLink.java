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
import org.dfra.drivers.link.ReopeningLink;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * A link to a device. It is kept open, and reopened when the device gives no sign of life.
 *
 * <p>Parameters that it reads: {@code link}, {@code reopen_initial_delay} and {@code
 * reopen_max_delay}, see {@link LinkSettings}. Parameters that it publishes, by {@link #declareIn}:
 * {@code frames}, {@code dropped_bytes}, {@code malformed_frames}. Tests: {@code link}, {@code
 * readings}; recovery: {@code reopen_link}.
 *
 * <p>Threads: one reader ({@code name reader}), owned from {@link #start} to {@link #close}, calls
 * the protocol. Any thread may call {@link #send} and the queries.
 */
public final class DeviceLink implements ReopeningLink {

  private static final String LIFE = "sign of life";

  private final DeviceProtocol protocol;
  private final Ticker ticker;
  private final LinkKeeper keeper;
  private final EventCounter eventCounter;
  private final LinkDiagnostics diagnostics;

  /** Bytes from other threads, sent by the reader, which alone has the link. */
  private final ConcurrentLinkedQueue<byte[]> outbox = new ConcurrentLinkedQueue<>();

  private volatile @Nullable SerialLink link;
  private volatile StreamCounts counts = StreamCounts.ZERO;
  private long lifeNanos; // confined to the reader

  /**
   * @param context the driver's context
   * @param protocol the device's protocol
   * @param ticker the clock for waits
   * @param source opens the link; null to use the parameter {@code link}
   * @param log where changes of the link are logged
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
            new ReconnectingHandler(),
            LinkSettings.backOff(context.parameters()),
            ticker,
            log);
    this.diagnostics = new LinkDiagnostics(keeper, eventCounter);
  }

  /** Declares the tests, recoveries and parameters of every device behind a link, see above. */
  public void declareIn(Diagnostics examinations, ParameterTable table) {
    examinations.addTest("link", this::link);
    examinations.addTest("readings", this::life);
    examinations.addRecovery("reopen_link", this::reopenLink);
    showCounts(table, () -> counts);
  }

  /**
   * Declares {@code frames}, {@code dropped_bytes} and {@code malformed_frames} as read-only
   * parameters.
   */
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

  /** Starts to open the link; does nothing when already started. */
  @Override
  public void start() {
    keeper.start();
  }

  /** Closes the link permanently and returns when no more notifications will follow. */
  @Override
  public void close() {
    keeper.close();
  }

  /**
   * Queues bytes for sending; from any thread. They are discarded when the link is reopened first.
   * The reader sends them within 0.1 s; for a shorter delay see {@link #sendNow}.
   */
  public void send(byte[] bytes) {
    outbox.add(bytes);
  }

  /**
   * Writes bytes to the link immediately; from any thread. Messages are never interleaved.
   *
   * @return false if there is no link or it has just been lost; then nothing is sent later
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
      return false; // the reader detects it too, and reports the reason
    }
  }

  /** The device has given a sign of life; on the reader thread. */
  public void reportAlive() {
    lifeNanos = ticker.nanos();
    eventCounter.increment(LIFE);
  }

  /** Counts the device's messages, for threads that wait for one. */
  public EventCounter eventCounter() {
    return eventCounter;
  }

  /** What has been received over the link since the start, over all openings. */
  public StreamCounts counts() {
    return counts;
  }

  /** Whether the link is open. */
  public boolean isOpen() {
    return keeper.isOpen();
  }

  /** Closes and reopens the link. */
  public void reopen() {
    keeper.reopen();
  }

  /** Checks that the link is open. */
  public DiagnosticFinding link() {
    return diagnostics.link();
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

  /** Reopens the link and waits for a sign of life; returns a finding. */
  public DiagnosticFinding reopenLink() throws InterruptedException {
    return diagnostics.reopen("device", this::nextLife);
  }

  /** Handles the link, from one opening to the next; on the reader thread. */
  private final class ReconnectingHandler implements LinkHandler {

    @Override
    public void opened(SerialLink opened) throws IOException {
      lifeNanos = ticker.nanos();
      outbox.clear();
      protocol.opened(opened);
      link = opened;
      diagnostics.opened();
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
          ? protocol.silenceReason(longest)
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
