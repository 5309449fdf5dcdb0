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
      String command, boolean isQuestion, Consumer<PtuReply> handler, long sentNanos) {}

  /** How long the reader waits for a write of another thread, real time. */
  private static final long PATIENCE_MILLIS = 50;

  /** How long a halt waits for a write of another thread, real time. */
  private static final long HALT_PATIENCE_MILLIS = 100;

  private final Predicate<byte[]> sender;
  private final Ticker ticker;
  private final BiConsumer<String, String> refusals;
  private final ArrayDeque<Pending> queue = new ArrayDeque<>(); // guarded by this

  /** Held during a write, so that commands are queued as they are written; taken before this. */
  private final ReentrantLock writing = new ReentrantLock();

  /** A halt was sent past a write; it is repeated after that. Cleared under writing. */
  private volatile boolean isHaltPending;

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
  boolean send(List<String> commands) {
    writing.lock();
    try {
      sendPendingHalt();
      return sendImmediately(commands);
    } finally {
      unlock();
    }
  }

  /**
   * Has the unit stop, also where a write of whichever thread, the reader's too, is held up: after
   * 0.1 s it is sent past that, and once more after it, since the two may have been mixed.
   */
  boolean halt() {
    List<String> halt = List.of(PtuCommands.HALT);
    if (!lockWithin(HALT_PATIENCE_MILLIS)) {
      isHaltPending = true;
      boolean isSent = sendImmediately(halt);
      repeatHalt(); // where the write has ended meanwhile
      return isSent;
    }
    try {
      isHaltPending = false;
      return sendImmediately(halt);
    } finally {
      unlock();
    }
  }

  /** The thread that has written does it, or the one that owes it, if none writes. */
  private void repeatHalt() {
    while (isHaltPending && writing.tryLock()) {
      try {
        sendPendingHalt();
      } finally {
        writing.unlock();
      }
    }
  }

  /** Under writing. */
  private void sendPendingHalt() {
    if (isHaltPending) {
      isHaltPending = false;
      boolean unused = sendImmediately(List.of(PtuCommands.HALT));
    }
  }

  private void unlock() {
    writing.unlock();
    repeatHalt();
  }

  /** Also for a thread that is interrupted, where nobody writes. */
  private boolean lockWithin(long millis) {
    try {
      return writing.tryLock() || writing.tryLock(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /**
   * The same as {@link #send(List)}, past a write that is held up. Whichever of the two reaches the
   * unit first, commands are answered alike. Where a question is held up, its number may come where
   * {@code *} was expected; then the unit is set up anew.
   */
  boolean sendImmediately(List<String> commands) {
    long now = ticker.nanos();
    synchronized (this) {
      for (String command : commands) {
        queue.add(new Pending(command, false, reply -> {}, now));
      }
    }
    return sender.test(PtuCommands.bytes(commands));
  }

  /** Tells it to do one thing, and hears when it has; by the reader. */
  boolean send(String command, Consumer<PtuReply> handler) {
    return write(new Pending(command, false, handler, ticker.nanos()));
  }

  /** Asks it something; only when {@link #mayAsk}; by the reader. */
  boolean ask(String question, Consumer<PtuReply> handler) {
    return write(new Pending(question, true, handler, ticker.nanos()));
  }

  /** False also where a write of another thread is held up. */
  private boolean write(Pending next) {
    if (!lockWithin(PATIENCE_MILLIS)) {
      return false;
    }
    try {
      sendPendingHalt();
      synchronized (this) {
        queue.add(next);
      }
      return sender.test(PtuCommands.bytes(List.of(next.command())));
    } finally {
      unlock();
    }
  }

  /** Whether no question waits for its answer. */
  synchronized boolean mayAsk() {
    return queue.stream().noneMatch(Pending::isQuestion);
  }

  /** The unit has replied; false when this cannot be the reply to what is next in the queue. */
  boolean replyReceived(PtuReply reply) {
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
    next.handler().accept(reply);
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
