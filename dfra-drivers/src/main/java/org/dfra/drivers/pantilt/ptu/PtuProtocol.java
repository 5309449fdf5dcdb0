package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.DoubleSupplier;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.pantilt.ptu.PtuReply.LimitHit;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;

/**
 * What is said to the unit, and when.
 *
 * <pre>
 *              opened
 *                v
 *   +------&gt; LISTENING   ignores what still comes, until it is quiet
 *   |            v quiet for 0.3 s: ED FT I
 *   |        SETTLING    awaits * for each
 *   |            v
 *   |        ASKING      resolution, limits and speeds of both axes, one after the other
 *   |            v all told
 *   |        POLLING     the position of one axis, then of the other, at the rate
 *   |            v somebody wants it to be reset: R
 *   |        RESETTING   its * comes when the head points to 0, 0
 *   |            v
 *   +--- out of step, no reply in time, or reset
 * </pre>
 *
 * <p>Confined to the reader, but for {@link #want}, {@link #tell}, {@link #halt} and {@link
 * #tellNow}.
 */
final class PtuProtocol implements DeviceProtocol {

  /** What the driver is told; by the reader. */
  interface Listener {

    /** The unit has told what its axes can. */
    void measured(PtuGeometry geometry);

    /** The head points there, positions of the unit. */
    void points(int pan, int tilt);

    /** An axis ran against its end. */
    void hit(PtuAxis axis);

    /** The unit goes through its reset. */
    void resetting();

    /** A command was refused, for the reason. */
    void refused(String command, String reason);

    /** It answered a question that was {@linkplain #want wanted}, or its reset is done. */
    void answered(String question, PtuReply reply);

    /** What it said cannot be; it is asked again. */
    void puzzled(String how);

    /** There is no unit now. */
    void lost(String reason);

    /** It gave a sign of life. */
    void alive();
  }

  private enum Phase {
    LISTENING,
    SETTLING,
    ASKING,
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
  private final PtuDialogue dialogue;
  private final PtuParser parser = new PtuParser(this::heard);
  private final Queue<String> wishes = new ConcurrentLinkedQueue<>();

  private Phase phase = Phase.LISTENING;
  private PtuQuestions questions = new PtuQuestions();
  private long quietSince;
  private long polled;
  private int unsettled;
  private int pan;

  /**
   * @param listener is told what the unit says
   * @param ticker the time to wait by
   * @param rate polls per second
   * @param sender hands bytes to the line at once; false when there is none
   */
  PtuProtocol(Listener listener, Ticker ticker, DoubleSupplier rate, Predicate<byte[]> sender) {
    this.listener = listener;
    this.ticker = ticker;
    this.rate = rate;
    this.dialogue = new PtuDialogue(sender, ticker, listener::refused);
  }

  /** Tells the unit to do something now; from any thread. False when there is no link. */
  boolean tell(List<String> commands) {
    return dialogue.tell(commands);
  }

  /** Has the unit stop, past a write of another thread where that is held up; from any thread. */
  boolean halt() {
    return dialogue.halt();
  }

  /** The same as {@link #tell}, past a command that another thread is held up with. */
  boolean tellNow(List<String> commands) {
    return dialogue.tellNow(commands);
  }

  /** Has a question asked soon, or the unit reset; from any thread. */
  void want(String question) {
    wishes.add(question);
  }

  @Override
  public void opened(SerialLink link) {
    wishes.clear();
    listen();
  }

  private void listen() {
    dialogue.forget();
    phase = Phase.LISTENING;
    quietSince = ticker.nanos();
  }

  @Override
  public PtuParser parser() {
    return parser;
  }

  @Override
  public Duration attention() {
    return ATTENTION;
  }

  @Override
  public Duration longestSilence() {
    return phase == Phase.RESETTING ? LONGEST_RESET : SILENCE;
  }

  @Override
  public String expected() {
    return "position";
  }

  @Override
  public void lost(String reason) {
    dialogue.forget();
    listener.lost(reason);
  }

  @Override
  public void tend(SerialLink link) {
    if (phase == Phase.LISTENING) {
      if (since(quietSince).compareTo(QUIET) >= 0) {
        settle();
      }
      return;
    }
    String overdue = dialogue.overdue(phase == Phase.RESETTING ? LONGEST_RESET : REPLY);
    if (!overdue.isEmpty()) {
      again("it has not replied to " + overdue);
    } else if (phase == Phase.ASKING && dialogue.mayAsk()) {
      askNext();
    } else if (phase == Phase.POLLING && dialogue.mayAsk()) {
      poll();
    }
  }

  private void settle() {
    dialogue.forget();
    phase = Phase.SETTLING;
    List<String> settings =
        List.of(PtuCommands.NO_ECHO, PtuCommands.TERSE, PtuCommands.IMMEDIATELY);
    unsettled = settings.size();
    for (String setting : settings) {
      if (!dialogue.tell(setting, this::settled)) {
        listen(); // another thread's write is held up; all of them once more, after it
        return;
      }
    }
  }

  private void settled(PtuReply reply) {
    if (reply instanceof Refused refused) {
      again("it refuses to be set up: " + refused.message());
    } else if (--unsettled == 0) {
      questions = new PtuQuestions();
      phase = Phase.ASKING;
    }
  }

  private void askNext() {
    String question = questions.next();
    boolean unused = dialogue.ask(question, reply -> answered(question, reply));
  }

  private void answered(String question, PtuReply reply) {
    String fault = questions.take(question, reply);
    if (!fault.isEmpty()) {
      again(fault);
      return;
    }
    listener.alive();
    PtuGeometry geometry = questions.geometry();
    if (geometry != null) {
      phase = Phase.POLLING;
      polled = ticker.nanos() - Math.round(1e9 / rate.getAsDouble());
      listener.measured(geometry);
    }
  }

  private void poll() {
    String wish = wishes.peek();
    if (wish != null) {
      if (fulfil(wish)) {
        String unused = wishes.poll();
      }
      return;
    }
    long period = Math.round(1e9 / rate.getAsDouble());
    long late = ticker.nanos() - polled - period;
    if (late >= 0) {
      polled += period + Math.max(0, late - period); // in step, but never catching up
      ask(PtuAxis.PAN, position -> pan = position);
    }
  }

  /** False where another thread's write is held up, and it is to be tried again. */
  private boolean fulfil(String wish) {
    if (!wish.equals(PtuCommands.RESET)) {
      return dialogue.ask(wish, reply -> listener.answered(wish, reply));
    }
    if (dialogue.tell(wish, this::reset)) {
      phase = Phase.RESETTING;
      listener.resetting();
    } else { // later it might move the head under a commander, or while it is stopped
      listener.answered(wish, new Refused("the line is held up by a command; try again later"));
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
        dialogue.ask(PtuCommands.position(axis), reply -> position(axis, reply, taker));
  }

  private void position(PtuAxis axis, PtuReply reply, IntConsumer taker) {
    double number =
        reply instanceof PtuReply.Value value ? value.number().orElse(Double.NaN) : Double.NaN;
    if (number != Math.rint(number)) { // NaN too
      again("it tells no position of " + axis);
      return;
    }
    taker.accept((int) number);
    if (axis == PtuAxis.PAN) {
      ask(PtuAxis.TILT, tilt -> listener.points(pan, tilt));
    } else {
      listener.alive();
    }
  }

  private void heard(PtuReply reply) {
    quietSince = ticker.nanos();
    if (reply instanceof LimitHit hit) {
      if (phase != Phase.RESETTING) { // whose way leads to the ends
        listener.hit(hit.axis());
      }
    } else if (phase != Phase.LISTENING && !dialogue.heard(reply)) {
      again("it replied " + reply + " to something else");
    }
  }

  private void again(String why) {
    listener.puzzled(why);
    listen();
  }

  private Duration since(long nanos) {
    return Duration.ofNanos(ticker.nanos() - nanos);
  }
}
