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
 *               next speed                     as LmsPlan says
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
 * follows, see {@link LmsTuning}. A laser at rest is asked how it is every {@value #REST_SECONDS}
 * s.
 *
 * <p>Confined to the reader thread, but for {@link #inquire}, {@link #renegotiate} and {@link
 * #reset}.
 */
final class LmsProtocol implements DeviceProtocol {

  /** Counted by {@link LmsListener#heard} when the laser has become as wanted. */
  static final String PREPARED = "prepared";

  private static final int REST_SECONDS = 2;
  private static final Duration LOOK = Duration.ofMillis(10);
  private static final Duration SEARCH = Duration.ofSeconds(12);

  private final LmsOrders orders;
  private final Ticker ticker;
  private final LmsListener listener;
  private final LmsParser parser = new LmsParser(this::heard);
  private final LmsPlan plan;
  private final LmsTuning tuning;
  private final LmsSpeeds speeds;

  private final LmsErrand errand = new LmsErrand();
  private final LmsRhythm rhythm = new LmsRhythm(); // of polls, or looks at one that rests

  private volatile boolean toldPrepared; // since the search began
  private volatile boolean toRenegotiate;
  private volatile boolean toReset;

  LmsProtocol(LmsOrders orders, Ticker ticker, LmsListener listener) {
    this.orders = orders;
    this.ticker = ticker;
    this.listener = listener;
    this.plan = new LmsPlan(orders);
    this.tuning = new LmsTuning(orders.baud());
    this.speeds = tuning.speeds();
  }

  /** Has something asked when there is time; from any thread. */
  void inquire(LmsRequest request) {
    plan.inquire(request);
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
  boolean isPrepared() {
    return toldPrepared;
  }

  /** How often the laser's flash memory was written; for any thread. */
  int writes() {
    return plan.writes();
  }

  @Override
  public void opened(SerialLink link) throws IOException {
    toRenegotiate = false;
    toReset = false;
    begin(link);
  }

  private void begin(SerialLink link) throws IOException {
    plan.forget();
    speeds.begin();
    toldPrepared = false;
    search(link);
  }

  /** Looks for the laser at the next speed to be tried. */
  private void search(SerialLink link) throws IOException {
    errand.end();
    plan.lost();
    rhythm.begin();
    String trouble = tuning.search(link, ticker.nanos());
    if (trouble != null) {
      listener.warned(trouble);
    }
    listener.withoutScans(link + " is open, the laser does not answer yet" + speeds.inWords());
  }

  @Override
  public LmsParser parser() {
    return parser;
  }

  /** Where it is polled often, or both ends are left alone, 0.1 s would be too long a wait. */
  @Override
  public Duration attention() {
    boolean isBusy = orders.isPolled() || tuning.isQuiet(ticker.nanos());
    return isBusy ? LOOK : DeviceProtocol.super.attention();
  }

  @Override
  public Duration longestSilence() {
    if (tuning.isWaking()) {
      return LmsTuning.WAKING.plusSeconds(5);
    }
    LmsVariant variant = plan.variant();
    if (variant == null || !scans()) {
      return SEARCH.plus(Kind.CONFIGURE.patience());
    }
    double period = 1 / variant.rate(speeds.now().orElse(LmsBaud.B9600).rate());
    return orders.isPolled()
        ? Duration.ofMillis(Math.round(4000 + 3000 * Math.max(period, orders.period())))
        : Duration.ofMillis(Math.round(2000 + 3000 * period));
  }

  /** Whether scans ought to come now. */
  private boolean scans() {
    return plan.isPrepared() && (plan.isStreaming() || polls());
  }

  private boolean polls() {
    return orders.isPolled() && !listener.rests() && plan.obstacle() == null;
  }

  @Override
  public String expected() {
    return scans() ? "scan" : "answer of a laser";
  }

  @Override
  public void lost(String reason) {
    errand.end();
    toldPrepared = false;
    plan.lost();
    listener.withoutScans(reason);
  }

  @Override
  public void tend(SerialLink link) throws IOException {
    long now = ticker.nanos();
    if (!tuning.tend(link, now) || toRenegotiate) {
      toRenegotiate = false;
      begin(link);
    } else if (errand.isOverdue(now)) {
      judge(link, now);
    }
    if (errand.kind() == null && !tuning.isQuiet(now)) {
      LmsRequest next = next(now);
      if (next != null && mayBeSent(link, next)) {
        plan.sent(next.kind());
        errand.begin(link, next, now);
      }
    }
  }

  private @Nullable LmsRequest next(long now) {
    boolean rests = listener.rests();
    if (toReset && plan.isPrepared()) {
      toReset = false;
      return LmsRequest.RESET;
    }
    LmsRequest next = plan.next(speeds.now(), rests);
    if (!toldPrepared && plan.isPrepared() && (next == null || next.kind() == Kind.STREAM)) {
      toldPrepared = true;
      listener.heard(PREPARED);
    }
    if (next != null || plan.isStreaming()) {
      return next;
    }
    boolean polls = polls();
    return rhythm.isDue(now, polls ? orders.period() : REST_SECONDS)
        ? polls ? LmsRequest.SCAN : LmsRequest.STATUS
        : null;
  }

  /** Whether it makes sense: a speed that this end cannot have is of no use. */
  private boolean mayBeSent(SerialLink link, LmsRequest next) throws IOException {
    String trouble = next.kind() == Kind.BAUD ? speeds.tryWanted(link) : null;
    if (trouble != null) {
      listener.warned(trouble);
      plan.giveUp(Kind.BAUD);
    }
    return trouble == null;
  }

  /** No answer has come: asks again, or takes the laser for lost. */
  private void judge(SerialLink link, long now) throws IOException {
    Kind kind = errand.kind();
    if (kind == null || errand.repeat(link, speeds.isFound(), now)) {
      return;
    }
    if (kind == Kind.TYPE || kind == Kind.ERRORS) { // old ones may not know them
      errand.end();
      plan.giveUp(kind);
      listener.warned("the laser was asked " + kind.words() + " and does not answer that");
    } else {
      if (speeds.isFound()) {
        listener.warned("the laser was asked " + kind.words() + " and does not answer any more");
        speeds.begin();
      }
      search(link);
    }
  }

  private void heard(LmsMessage message) {
    if (message instanceof LmsMessage.Malformed malformed) {
      listener.malformed(malformed.name(), malformed.reason());
    } else if (message instanceof LmsMessage.Nak) {
      errand.unread();
    } else if (message instanceof LmsMessage.Telegram telegram) {
      errand.heard();
      listener.told(telegram);
      take(telegram);
    }
  }

  private void take(LmsMessage.Telegram telegram) {
    Kind kind = errand.kind();
    if (telegram instanceof LmsMessage.Type type && type.wakes()) {
      woke();
    } else if (kind != null && kind.answer().equals(telegram.name())) {
      answered(kind, telegram);
    } else if (kind != null && telegram instanceof LmsMessage.Refused) {
      errand.end();
      listener.warned(plan.refused(kind));
    }
    if (telegram instanceof LmsScan scan) {
      take(scan);
    }
    listener.heard(telegram.name());
  }

  /** It was reset, by us or by its switch. */
  private void woke() {
    tuning.woke();
    toldPrepared = false;
    errand.end();
    plan.forget();
    listener.withoutScans("the laser has woken and is told what to do");
  }

  private void answered(Kind kind, LmsMessage.Telegram answer) {
    errand.end();
    speeds.found();
    String sentence = plan.answered(kind, answer);
    if (sentence != null) {
      listener.warned(sentence);
    } else if (kind == Kind.BAUD) {
      tuning.switched();
    } else if (kind == Kind.RESET) {
      plan.forget();
      tuning.resets(ticker.nanos());
      listener.withoutScans("the laser resets itself");
    }
    if (answer instanceof LmsStatus told) {
      told.baud().ifPresent(speeds::told);
      String obstacle = plan.obstacle();
      listener.awaits(obstacle == null ? "no scan has come yet" : obstacle);
    }
  }

  private void take(LmsScan scan) {
    LmsVariant variant = plan.variant();
    Optional<MeasuringMode> mode = plan.mode();
    if (variant == null || mode.isEmpty() || !plan.isPrepared()) {
      return; // of a stream that somebody else began
    }
    if (scan.beams() != variant.beams()) {
      String reason = scan.beams() + " beams came, where " + variant.inWords() + " was set";
      listener.malformed("B0", reason);
      listener.withoutScans(reason);
      plan.doubt();
      return;
    }
    listener.scanned(scan, mode.get(), variant, speeds.now().orElse(LmsBaud.B9600).rate());
  }
}
