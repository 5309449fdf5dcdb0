package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.pantilt.ptu.PtuReply.Done;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;

/**
 * Whose reply is whose. Replies do not say what they answer, but come in the order of the commands;
 * so commands and what is to become of their replies are put into one queue. One question at the
 * most waits in it, so that one number is never taken for another when a reply is lost: a number
 * where {@code *} was expected, or the other way round, shows that.
 *
 * <p>Commands come from any thread, replies from the reader's.
 */
final class PtuDialogue {

  /** What was sent and has no reply yet. */
  private record Pending(
      String command, boolean isQuestion, Consumer<PtuReply> taker, long sentNanos) {}

  private final Predicate<byte[]> sender;
  private final Ticker ticker;
  private final BiConsumer<String, String> refusals;
  private final ArrayDeque<Pending> queue = new ArrayDeque<>(); // guarded by this

  /**
   * @param sender hands bytes to the line at once; false when there is none
   * @param ticker the time to measure replies by
   * @param refusals is told command and reason of each that the unit refuses
   */
  PtuDialogue(Predicate<byte[]> sender, Ticker ticker, BiConsumer<String, String> refusals) {
    this.sender = sender;
    this.ticker = ticker;
    this.refusals = refusals;
  }

  /** Tells the unit to do something; false when there is no link. */
  synchronized boolean tell(List<String> commands) {
    long now = ticker.nanos();
    for (String command : commands) {
      queue.add(new Pending(command, false, reply -> {}, now));
    }
    return sender.test(PtuCommands.bytes(commands));
  }

  /** Tells it to do one thing, and hears when it has. */
  synchronized boolean tell(String command, Consumer<PtuReply> taker) {
    queue.add(new Pending(command, false, taker, ticker.nanos()));
    return sender.test(PtuCommands.bytes(List.of(command)));
  }

  /** Asks it something; only when {@link #mayAsk}. */
  synchronized boolean ask(String question, Consumer<PtuReply> taker) {
    queue.add(new Pending(question, true, taker, ticker.nanos()));
    return sender.test(PtuCommands.bytes(List.of(question)));
  }

  /** Whether no question waits for its answer. */
  synchronized boolean mayAsk() {
    return queue.stream().noneMatch(Pending::isQuestion);
  }

  /** The unit has replied; false when this cannot be the reply to what is next in the queue. */
  boolean heard(PtuReply reply) {
    Pending next;
    synchronized (this) {
      next = queue.poll();
    }
    if (next == null) {
      return false;
    }
    if (reply instanceof Refused refused) {
      refusals.accept(next.command(), refused.message());
    } else if (next.isQuestion() ? !(reply instanceof Value) : !(reply instanceof Done)) {
      return false;
    }
    next.taker().accept(reply);
    return true;
  }

  /** What has waited for its reply for longer than that, for people; empty when nothing has. */
  synchronized String overdue(Duration patience) {
    Pending first = queue.peek();
    return first != null && ticker.nanos() - first.sentNanos() > patience.toNanos()
        ? first.command()
        : "";
  }

  /** Nothing is expected any more. */
  synchronized void forget() {
    queue.clear();
  }
}
