package org.dfra.drivers.laser.lms;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.PollTimer;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * The exchange between the driver and the laser, from one opening of the link to the next.
 *
 * <pre>
 *               next rate                      requests of LmsConfigurator
 *             .------------.                  .---------------.
 *             v            |                  v               |
 *   opened -&gt; SEARCHING ---'--- answers ---&gt; PREPARING -------'--&gt; WORKING &lt;--clients--&gt; IDLE
 *             ^     ^                         |  |                  |                     |
 *             |     '-- no answer, 3 times ---'  '-- changed settings, a query -----------'
 *             |                                                     |
 *             '---- it has started (90), or 60 s after a reset -----'
 * </pre>
 *
 * <p>One request is pending at a time. It is resent when the laser could not read it (NAK), and
 * when no answer was received. Where the driver may set the link's baud rate, it searches for the
 * laser at the configured rate, then at the others, and then switches the laser to the configured
 * rate; the driver's own end follows, see {@link LmsBaudSynchronizer}. An idle laser's status is
 * queried every {@value #IDLE_POLL_SECONDS} s.
 *
 * <p>Confined to the reader thread, except {@link #enqueue}, {@link #renegotiate} and {@link
 * #reset}.
 */
final class LmsProtocol implements DeviceProtocol {

  /** Event of {@link LmsListener#messageReceived} when the laser has the required settings. */
  static final String PREPARED = "prepared";

  private static final int IDLE_POLL_SECONDS = 2;
  private static final Duration POLL_INTERVAL = Duration.ofMillis(10);
  private static final Duration SEARCH = Duration.ofSeconds(12);

  private final LmsSettings settings;
  private final Ticker ticker;
  private final LmsListener listener;
  private final LmsParser parser = new LmsParser(this::messageReceived);
  private final LmsConfigurator plan;
  private final LmsBaudSynchronizer tuning;
  private final LmsBaudSearch speeds;

  private final PendingRequest pendingRequest = new PendingRequest();
  private final PollTimer pollTimer = new PollTimer(); // of polls, or of status queries when idle

  private volatile boolean configuredReported; // since the search began
  private volatile boolean toRenegotiate;
  private volatile boolean toReset;

  LmsProtocol(LmsSettings orders, Ticker ticker, LmsListener listener) {
    this.settings = orders;
    this.ticker = ticker;
    this.listener = listener;
    this.plan = new LmsConfigurator(orders);
    this.tuning = new LmsBaudSynchronizer(orders.baud());
    this.speeds = tuning.speeds();
  }

  /** Queues a request; from any thread. */
  void enqueue(LmsRequest request) {
    plan.enqueue(request);
  }

  /** Searches for the laser at all baud rates and configures it again; from any thread. */
  void renegotiate() {
    toRenegotiate = true;
  }

  /** Resets the laser; from any thread. */
  void reset() {
    toReset = true;
  }

  /** Whether the laser has been configured since the link was opened; from any thread. */
  boolean isConfigured() {
    return configuredReported;
  }

  /** How often the laser's flash memory was written; from any thread. */
  int flashWrites() {
    return plan.flashWrites();
  }

  @Override
  public void opened(SerialLink link) throws IOException {
    toRenegotiate = false;
    toReset = false;
    begin(link);
  }

  private void begin(SerialLink link) throws IOException {
    plan.forget();
    speeds.restart();
    configuredReported = false;
    search(link);
  }

  /** Searches for the laser at the next baud rate. */
  private void search(SerialLink link) throws IOException {
    pendingRequest.end();
    plan.lost();
    pollTimer.begin();
    String warning = tuning.search(link, ticker.nanos());
    if (warning != null) {
      listener.warn(warning);
    }
    listener.scansLost(link + " is open, the laser does not answer yet" + speeds.inWords());
  }

  @Override
  public LmsParser parser() {
    return parser;
  }

  /** Shorter for frequent polls and rate changes, where 0.1 s would be too long. */
  @Override
  public Duration pollInterval() {
    boolean isBusy = settings.isPolled() || tuning.isQuiet(ticker.nanos());
    return isBusy ? POLL_INTERVAL : DeviceProtocol.super.pollInterval();
  }

  @Override
  public Duration livenessTimeout() {
    if (tuning.isPoweringOn()) {
      return LmsBaudSynchronizer.WAKING.plusSeconds(5);
    }
    LmsVariant variant = plan.variant();
    if (variant == null || !scans()) {
      return SEARCH.plus(Kind.CONFIGURE.timeout());
    }
    double period = 1 / variant.rate(speeds.now().orElse(LmsBaud.B9600).rate());
    return settings.isPolled()
        ? Duration.ofMillis(Math.round(4000 + 3000 * Math.max(period, settings.period())))
        : Duration.ofMillis(Math.round(2000 + 3000 * period));
  }

  /** Whether scans are expected now. */
  private boolean scans() {
    return plan.isConfigured() && (plan.isStreaming() || polls());
  }

  private boolean polls() {
    return settings.isPolled() && !listener.isIdleRequested() && plan.unusableReason() == null;
  }

  @Override
  public String expected() {
    return scans() ? "scan" : "answer of a laser";
  }

  @Override
  public void lost(String reason) {
    pendingRequest.end();
    configuredReported = false;
    plan.lost();
    listener.scansLost(reason);
  }

  @Override
  public void periodic(SerialLink link) throws IOException {
    long now = ticker.nanos();
    if (!tuning.update(link, now) || toRenegotiate) {
      toRenegotiate = false;
      begin(link);
    } else if (pendingRequest.isOverdue(now)) {
      judge(link, now);
    }
    if (pendingRequest.kind() == null && !tuning.isQuiet(now)) {
      LmsRequest next = next(now);
      if (next != null && mayBeSent(link, next)) {
        plan.sent(next.kind());
        pendingRequest.start(link, next, now);
      }
    }
  }

  private @Nullable LmsRequest next(long now) {
    boolean rests = listener.isIdleRequested();
    if (toReset && plan.isConfigured()) {
      toReset = false;
      return LmsRequest.RESET;
    }
    LmsRequest next = plan.next(speeds.now(), rests);
    if (!configuredReported
        && plan.isConfigured()
        && (next == null || next.kind() == Kind.STREAM)) {
      configuredReported = true;
      listener.messageReceived(PREPARED);
    }
    if (next != null || plan.isStreaming()) {
      return next;
    }
    boolean polls = polls();
    return pollTimer.isDue(now, polls ? settings.period() : IDLE_POLL_SECONDS)
        ? polls ? LmsRequest.SCAN : LmsRequest.STATUS
        : null;
  }

  /** Whether to send the request: a rate that this end does not support is useless. */
  private boolean mayBeSent(SerialLink link, LmsRequest next) throws IOException {
    String warning = next.kind() == Kind.BAUD ? speeds.tryWanted(link) : null;
    if (warning != null) {
      listener.warn(warning);
      plan.giveUp(Kind.BAUD);
    }
    return warning == null;
  }

  /** Handles a missing answer: repeats the request, or treats the laser as lost. */
  private void judge(SerialLink link, long now) throws IOException {
    Kind kind = pendingRequest.kind();
    if (kind == null || pendingRequest.repeat(link, speeds.isFound(), now)) {
      return;
    }
    if (kind == Kind.TYPE || kind == Kind.ERRORS) { // old models may not support them
      pendingRequest.end();
      plan.giveUp(kind);
      listener.warn("the laser was asked " + kind.words() + " and does not answer that");
    } else {
      if (speeds.isFound()) {
        listener.warn("the laser was asked " + kind.words() + " and does not answer any more");
        speeds.restart();
      }
      search(link);
    }
  }

  private void messageReceived(LmsMessage message) {
    if (message instanceof LmsMessage.Malformed malformed) {
      listener.malformedReceived(malformed.name(), malformed.reason());
    } else if (message instanceof LmsMessage.Nak) {
      pendingRequest.markUnreadable();
    } else if (message instanceof LmsMessage.Telegram telegram) {
      pendingRequest.markResponsive();
      listener.telegramReceived(telegram);
      take(telegram);
    }
  }

  private void take(LmsMessage.Telegram telegram) {
    Kind kind = pendingRequest.kind();
    if (telegram instanceof LmsMessage.TypeReply type && type.isPowerOn()) {
      poweredOn();
    } else if (kind != null && kind.answer().equals(telegram.name())) {
      answered(kind, telegram);
    } else if (kind != null && telegram instanceof LmsMessage.RefusedReply) {
      pendingRequest.end();
      listener.warn(plan.refused(kind));
    }
    if (telegram instanceof LmsScan scan) {
      take(scan);
    }
    listener.messageReceived(telegram.name());
  }

  /** The laser was reset, by this driver or by its power switch. */
  private void poweredOn() {
    tuning.poweredOn();
    configuredReported = false;
    pendingRequest.end();
    plan.forget();
    listener.scansLost("the laser has restarted and is configured again");
  }

  private void answered(Kind kind, LmsMessage.Telegram answer) {
    pendingRequest.end();
    speeds.markFound();
    String sentence = plan.answered(kind, answer);
    if (sentence != null) {
      listener.warn(sentence);
    } else if (kind == Kind.BAUD) {
      tuning.switched();
    } else if (kind == Kind.RESET) {
      plan.forget();
      tuning.resets(ticker.nanos());
      listener.scansLost("the laser resets itself");
    }
    if (answer instanceof LmsStatus reported) {
      reported.baud().ifPresent(speeds::laserReported);
      String obstacle = plan.unusableReason();
      listener.awaiting(obstacle == null ? "no scan has come yet" : obstacle);
    }
  }

  private void take(LmsScan scan) {
    LmsVariant variant = plan.variant();
    Optional<MeasuringMode> mode = plan.mode();
    if (variant == null || mode.isEmpty() || !plan.isConfigured()) {
      return; // of a stream that another program started
    }
    if (scan.beams() != variant.beams()) {
      String reason = scan.beams() + " beams came, where " + variant.inWords() + " was set";
      listener.malformedReceived("B0", reason);
      listener.scansLost(reason);
      plan.invalidate();
      return;
    }
    listener.scanReceived(scan, mode.get(), variant, speeds.now().orElse(LmsBaud.B9600).rate());
  }

  /** Receives what the laser reports; on the reader thread. */
  interface LmsListener {

    /**
     * An intact message has been received, or {@link LmsProtocol#PREPARED}; for threads that wait
     * for it.
     */
    void messageReceived(String name);

    /**
     * A scan that can be interpreted.
     *
     * @param mode measuring mode, which defines the distance bits of a sample
     * @param variant its field of view and resolution
     * @param baud bits per second of its link
     */
    void scanReceived(LmsScan scan, MeasuringMode mode, LmsVariant variant, int baud);

    /** Every intact telegram. */
    void telegramReceived(LmsMessage.Telegram telegram);

    /** An intact telegram with an invalid value. */
    void malformedReceived(String name, String reason);

    /** A warning for the operator, as a sentence. */
    void warn(String sentence);

    /** No scans are received, for this reason, a clause. */
    void scansLost(String reason);

    /** The laser answers, but no scan has been received yet: what is missing, a clause. */
    void awaiting(String what);

    /** Whether no scans are required now. */
    boolean isIdleRequested();
  }
}
