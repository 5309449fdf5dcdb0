package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
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
 * <p>Commands come from any thread, replies from the reader's. The reader never waits for a write
 * of another thread that is held up; so it notices that the unit is silent, and closes the link,
 * which sets the write free.
 */
final class PtuDialogue {

  /** What was sent and has no reply yet. */
  private record Pending(
      String command, boolean isQuestion, Consumer<PtuReply> taker, long sentNanos) {}

  /** How long the reader waits for a write of another thread, real time. */
  private static final long PATIENCE_MILLIS = 50;

  private final Predicate<byte[]> sender;
  private final Ticker ticker;
  private final BiConsumer<String, String> refusals;
  private final ArrayDeque<Pending> queue = new ArrayDeque<>(); // guarded by this

  /** Held during a write, so that commands are queued as they are written; taken before this. */
  private final ReentrantLock writing = new ReentrantLock();

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
  boolean tell(List<String> commands) {
    writing.lock();
    try {
      return tellNow(commands);
    } finally {
      writing.unlock();
    }
  }

  /**
   * The same, past a write that is held up. Whichever of the two reaches the unit first, both are
   * answered alike, so the replies stay in step.
   */
  boolean tellNow(List<String> commands) {
    long now = ticker.nanos();
    synchronized (this) {
      for (String command : commands) {
        queue.add(new Pending(command, false, reply -> {}, now));
      }
    }
    return sender.test(PtuCommands.bytes(commands));
  }

  /** Tells it to do one thing, and hears when it has; by the reader. */
  boolean tell(String command, Consumer<PtuReply> taker) {
    return write(new Pending(command, false, taker, ticker.nanos()));
  }

  /** Asks it something; only when {@link #mayAsk}; by the reader. */
  boolean ask(String question, Consumer<PtuReply> taker) {
    return write(new Pending(question, true, taker, ticker.nanos()));
  }

  /** False also where a write of another thread is held up. */
  private boolean write(Pending next) {
    try {
      if (!writing.tryLock(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
        return false;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
    try {
      synchronized (this) {
        queue.add(next);
      }
      return sender.test(PtuCommands.bytes(List.of(next.command())));
    } finally {
      writing.unlock();
    }
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
