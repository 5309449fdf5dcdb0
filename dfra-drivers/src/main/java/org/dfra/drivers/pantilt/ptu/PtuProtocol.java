package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.DoubleSupplier;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.PollTimer;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;
import org.dfra.drivers.pantilt.ptu.PtuGeometryQuery.PtuGeometry;
import org.dfra.drivers.pantilt.ptu.PtuReply.LimitHit;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;

/**
 * The exchange with the unit: what to send, and when.
 *
 * <pre>
 *              opened
 *                v
 *   +------&gt; AWAITING_QUIET  ignores received bytes until the link is quiet
 *   |            v quiet for 0.3 s: ED FT I
 *   |        CONFIGURING     awaits * for each
 *   |            v
 *   |        QUERYING        resolution, limits and speeds of both axes, one by one
 *   |            v all reported
 *   |        POLLING         the position of one axis, then of the other, at the rate
 *   |            v a reset is requested: R
 *   |        RESETTING       its * arrives when the head points to 0, 0
 *   |            v
 *   +--- replies out of order, reply timeout, or reset
 * </pre>
 *
 * <p>Confined to the reader, except {@link #request}, {@link #send}, {@link #halt} and {@link
 * #sendImmediately}.
 */
final class PtuProtocol implements DeviceProtocol {

  /** Receives the events; called by the reader. */
  interface Listener {

    /** The unit has reported the limits of its axes. */
    void geometryReceived(PtuGeometry geometry);

    /** The head's direction, in the unit's positions. */
    void positionReceived(int pan, int tilt);

    /** An axis ran into its end stop. */
    void limitHit(PtuAxis axis);

    /** The unit is being reset. */
    void resetting();

    /** The unit rejected a command. */
    void refused(String command, String reason);

    /** The unit answered a {@linkplain #request requested} query, or its reset is complete. */
    void answered(String question, PtuReply reply);

    /** A reply is inconsistent; the query is repeated. */
    void inconsistentReply(String how);

    /** The unit is lost. */
    void lost(String reason);

    /** The unit gave a sign of life. */
    void alive();
  }

  private enum Phase {
    AWAITING_QUIET,
    CONFIGURING,
    QUERYING,
    POLLING,
    RESETTING
  }

  private static final Duration QUIET = Duration.ofMillis(300);
  private static final Duration REPLY = Duration.ofSeconds(1);
  private static final Duration LONGEST_RESET = Duration.ofSeconds(60);
  private static final Duration SILENCE = Duration.ofSeconds(3);
  private static final Duration ATTENTION = Duration.ofMillis(5);

  private final Listener listener;
  private final Ticker ticker;
  private final DoubleSupplier rate;
  private final PtuExchange exchange;
  private final PtuParser parser = new PtuParser(this::replyReceived);
  private final PollTimer pollTimer = new PollTimer();
  private final Queue<String> requests = new ConcurrentLinkedQueue<>();

  private Phase phase = Phase.AWAITING_QUIET;
  private PtuGeometryQuery questions = new PtuGeometryQuery();
  private long quietSince;
  private int pendingConfigurationReplies;
  private int pan;

  /**
   * @param listener receives the unit's reports
   * @param ticker the clock for waits
   * @param rate polls per second
   * @param sender writes bytes to the link immediately; false when there is no link
   */
  PtuProtocol(Listener listener, Ticker ticker, DoubleSupplier rate, Predicate<byte[]> sender) {
    this.listener = listener;
    this.ticker = ticker;
    this.rate = rate;
    this.exchange = new PtuExchange(sender, ticker, listener::refused);
  }

  /** Sends commands to the unit; from any thread. False when there is no link. */
  boolean send(List<String> commands) {
    return exchange.send(commands);
  }

  /** Stops the unit; bypasses a blocked write of another thread; from any thread. */
  boolean halt() {
    return exchange.halt();
  }

  /** The same as {@link #send}, but bypasses a blocked write of another thread. */
  boolean sendImmediately(List<String> commands) {
    return exchange.sendImmediately(commands);
  }

  /** Queues a query or a reset; from any thread. */
  void request(String question) {
    requests.add(question);
  }

  @Override
  public void opened(SerialLink link) {
    requests.clear();
    listen();
  }

  private void listen() {
    exchange.forget();
    phase = Phase.AWAITING_QUIET;
    quietSince = ticker.nanos();
  }

  @Override
  public PtuParser parser() {
    return parser;
  }

  @Override
  public Duration pollInterval() {
    return ATTENTION;
  }

  @Override
  public Duration livenessTimeout() {
    return phase == Phase.RESETTING ? LONGEST_RESET : SILENCE;
  }

  @Override
  public String expected() {
    return "position";
  }

  @Override
  public void lost(String reason) {
    exchange.forget();
    listener.lost(reason);
  }

  @Override
  public void periodic(SerialLink link) {
    if (phase == Phase.AWAITING_QUIET) {
      if (since(quietSince).compareTo(QUIET) >= 0) {
        configure();
      }
      return;
    }
    String overdue = exchange.overdue(phase == Phase.RESETTING ? LONGEST_RESET : REPLY);
    if (!overdue.isEmpty()) {
      resynchronize("it has not replied to " + overdue);
    } else if (phase == Phase.QUERYING && exchange.mayAsk()) {
      askNext();
    } else if (phase == Phase.POLLING && exchange.mayAsk()) {
      poll();
    }
  }

  private void configure() {
    exchange.forget();
    phase = Phase.CONFIGURING;
    List<String> settings =
        List.of(PtuCommands.NO_ECHO, PtuCommands.TERSE, PtuCommands.IMMEDIATELY);
    pendingConfigurationReplies = settings.size();
    for (String setting : settings) {
      if (!exchange.send(setting, this::configurationReplied)) {
        listen(); // another thread's write is blocked; all are repeated after it
        return;
      }
    }
  }

  private void configurationReplied(PtuReply reply) {
    if (reply instanceof Refused refused) {
      resynchronize("it refuses to be set up: " + refused.message());
    } else if (--pendingConfigurationReplies == 0) {
      questions = new PtuGeometryQuery();
      phase = Phase.QUERYING;
    }
  }

  private void askNext() {
    String question = questions.nextQuestion();
    boolean unused = exchange.ask(question, reply -> answered(question, reply));
  }

  private void answered(String question, PtuReply reply) {
    String fault = questions.accept(question, reply);
    if (!fault.isEmpty()) {
      resynchronize(fault);
      return;
    }
    listener.alive();
    PtuGeometry geometry = questions.geometry();
    if (geometry != null) {
      phase = Phase.POLLING;
      pollTimer.begin();
      listener.geometryReceived(geometry);
    }
  }

  private void poll() {
    String wish = requests.peek();
    if (wish != null) {
      if (handleRequest(wish)) {
        String unused = requests.poll();
      }
      return;
    }
    if (pollTimer.isDue(ticker.nanos(), 1 / rate.getAsDouble())) {
      ask(PtuAxis.PAN, position -> pan = position);
    }
  }

  /** False if another thread's write is blocked, and the request must be retried. */
  private boolean handleRequest(String request) {
    if (!request.equals(PtuCommands.RESET)) {
      return exchange.ask(request, reply -> listener.answered(request, reply));
    }
    if (exchange.send(request, this::reset)) {
      phase = Phase.RESETTING;
      listener.resetting();
    } else { // later it might move the head under a commander, or during an emergency stop
      listener.answered(request, new Refused("the line is held up by a command; try again later"));
    }
    return true;
  }

  private void reset(PtuReply reply) {
    listener.alive();
    listener.answered(PtuCommands.RESET, reply);
    listen();
  }

  private void ask(PtuAxis axis, IntConsumer taker) {
    boolean unused =
        exchange.ask(PtuCommands.position(axis), reply -> position(axis, reply, taker));
  }

  private void position(PtuAxis axis, PtuReply reply, IntConsumer taker) {
    double number =
        reply instanceof PtuReply.Value value ? value.number().orElse(Double.NaN) : Double.NaN;
    if (number != Math.rint(number)) { // NaN too
      resynchronize("its answer contains no position of " + axis);
      return;
    }
    taker.accept((int) number);
    if (axis == PtuAxis.PAN) {
      ask(PtuAxis.TILT, tilt -> listener.positionReceived(pan, tilt));
    } else {
      listener.alive();
    }
  }

  private void replyReceived(PtuReply reply) {
    quietSince = ticker.nanos();
    if (reply instanceof LimitHit hit) {
      if (phase != Phase.RESETTING) { // a reset moves to the end stops
        listener.limitHit(hit.axis());
      }
    } else if (phase != Phase.AWAITING_QUIET && !exchange.replyReceived(reply)) {
      resynchronize("it replied " + reply + " to something else");
    }
  }

  private void resynchronize(String why) {
    listener.inconsistentReply(why);
    listen();
  }

  private Duration since(long nanos) {
    return Duration.ofNanos(ticker.nanos() - nanos);
  }
}
