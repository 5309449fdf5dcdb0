package org.dfra.drivers.laser.lms;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * What is said between the driver and the laser, from one opening of the link to the next.
 *
 * <pre>
 *               next speed                     as LmsConfigurator says
 *             .------------.                  .---------------.
 *             v            |                  v               |
 *   opened -&gt; SEARCHING ---'--- answers ---&gt; PREPARING -------'--&gt; WORKING &lt;--clients--&gt; RESTING
 *             ^     ^                         |  |                  |                     |
 *             |     '-- no answer, 3 times ---'  '-- another wish, an inquiry ------------'
 *             |                                                     |
 *             '---- it wakes (90), or 60 s after a reset -----------'
 * </pre>
 *
 * <p>One request is under way at a time. It is sent again when the laser could not read it (NAK),
 * and when no answer came. Where the driver may set the speed of the line, the laser is searched at
 * the wanted one, then at the others, and then told to use the wanted one; the driver's own end
 * follows, see {@link LmsBaudSynchronizer}. A laser at rest is asked how it is every {@value
 * #IDLE_POLL_SECONDS} s.
 *
 * <p>Confined to the reader thread, but for {@link #enqueue}, {@link #renegotiate} and {@link
 * #reset}.
 */
final class LmsProtocol implements DeviceProtocol {

  /** Counted by {@link LmsListener#messageReceived} when the laser has become as wanted. */
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
  private final PollTimer pollTimer = new PollTimer(); // of polls, or looks at one that rests

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

  /** Has something asked when there is time; from any thread. */
  void enqueue(LmsRequest request) {
    plan.enqueue(request);
  }

  /** Has the laser searched at all speeds and told all wishes anew; from any thread. */
  void renegotiate() {
    toRenegotiate = true;
  }

  /** Has the laser reset; from any thread. */
  void reset() {
    toReset = true;
  }

  /** Whether the laser has become as wanted since the link was opened; for any thread. */
  boolean isConfigured() {
    return configuredReported;
  }

  /** How often the laser's flash memory was written; for any thread. */
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

  /** Looks for the laser at the next speed to be tried. */
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

  /** Where it is polled often, or both ends are left alone, 0.1 s would be too long a wait. */
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

  /** Whether scans ought to come now. */
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

  /** Whether it makes sense: a speed that this end cannot have is of no use. */
  private boolean mayBeSent(SerialLink link, LmsRequest next) throws IOException {
    String warning = next.kind() == Kind.BAUD ? speeds.tryWanted(link) : null;
    if (warning != null) {
      listener.warn(warning);
      plan.giveUp(Kind.BAUD);
    }
    return warning == null;
  }

  /** No answer has come: asks again, or takes the laser for lost. */
  private void judge(SerialLink link, long now) throws IOException {
    Kind kind = pendingRequest.kind();
    if (kind == null || pendingRequest.repeat(link, speeds.isFound(), now)) {
      return;
    }
    if (kind == Kind.TYPE || kind == Kind.ERRORS) { // old ones may not know them
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

  /** It was reset, by us or by its switch. */
  private void poweredOn() {
    tuning.poweredOn();
    configuredReported = false;
    pendingRequest.end();
    plan.forget();
    listener.scansLost("the laser has woken and is told what to do");
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
      return; // of a stream that somebody else began
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
}
