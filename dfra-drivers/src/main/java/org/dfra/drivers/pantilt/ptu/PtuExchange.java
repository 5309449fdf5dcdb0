package org.dfra.drivers.pantilt.ptu;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
 * Matches replies to commands. Replies do not name their command, but arrive in the order of the
 * commands; so commands and the handlers of their replies are kept in one queue. At most one query
 * is in the queue, so that a number is never assigned to the wrong query when a reply is lost: a
 * number instead of an expected {@code *}, or the reverse, reveals the loss.
 *
 * <p>Any thread sends commands; the reader thread delivers replies. The reader never waits for a
 * blocked write of another thread; so it detects that the unit is silent and closes the link, which
 * unblocks the write.
 */
final class PtuExchange {

  /** A command that was sent and has no reply yet. */
  private record Pending(
      String command, boolean isQuestion, Consumer<PtuReply> handler, long sentNanos) {}

  /** How long the reader waits for a write of another thread, real time. */
  private static final long PATIENCE_MILLIS = 50;

  /** How long a halt waits for a write of another thread, real time. */
  private static final long HALT_PATIENCE_MILLIS = 100;

  private final Predicate<byte[]> sender;
  private final Ticker ticker;
  private final BiConsumer<String, String> refusals;

  @GuardedBy("this")
  private final ArrayDeque<Pending> queue = new ArrayDeque<>();

  /**
   * Held during a write, so that commands are queued in the order of writing; acquired before
   * {@code this}.
   */
  private final ReentrantLock writing = new ReentrantLock();

  /**
   * A halt bypassed a blocked write; it is repeated after that write. Cleared under {@code
   * writing}.
   */
  private volatile boolean isHaltPending;

  /**
   * @param sender writes bytes to the link immediately; false when there is no link
   * @param ticker the clock for reply timeouts
   * @param refusals receives the command and the reason of each rejection
   */
  PtuExchange(Predicate<byte[]> sender, Ticker ticker, BiConsumer<String, String> refusals) {
    this.sender = sender;
    this.ticker = ticker;
    this.refusals = refusals;
  }

  /** Sends commands to the unit; false when there is no link. */
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
   * Stops the unit, even if a write of any thread is blocked: after 0.1 s the halt bypasses that
   * write, and is repeated after it, because the two may have been interleaved.
   */
  boolean halt() {
    List<String> halt = List.of(PtuCommands.HALT);
    if (!lockWithin(HALT_PATIENCE_MILLIS)) {
      isHaltPending = true;
      boolean isSent = sendImmediately(halt);
      repeatHalt(); // if the write has ended meanwhile
      return isSent;
    }
    try {
      isHaltPending = false;
      return sendImmediately(halt);
    } finally {
      unlock();
    }
  }

  /**
   * Sends a pending halt again: the thread that has just written sends it, or, if none writes, the
   * caller.
   */
  private void repeatHalt() {
    while (isHaltPending && writing.tryLock()) {
      try {
        sendPendingHalt();
      } finally {
        writing.unlock();
      }
    }
  }

  /** Sends a pending halt; the caller holds {@code writing}. */
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

  /** Locks {@code writing}; an interrupted thread gets it too if it is free. */
  private boolean lockWithin(long millis) {
    try {
      return writing.tryLock() || writing.tryLock(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /**
   * The same as {@link #send(List)}, but bypasses a blocked write. All commands have the same
   * reply, so the order in which the two reach the unit does not matter. If a query is blocked, its
   * number may arrive instead of an expected {@code *}; then the unit is configured again.
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

  /** Sends one command with a reply handler; called by the reader. */
  boolean send(String command, Consumer<PtuReply> handler) {
    return write(new Pending(command, false, handler, ticker.nanos()));
  }

  /** Sends a query; only if {@link #mayAsk}; called by the reader. */
  boolean ask(String question, Consumer<PtuReply> handler) {
    return write(new Pending(question, true, handler, ticker.nanos()));
  }

  /** Writes and queues a command; false also if a write of another thread is blocked. */
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

  /** Whether no query is pending. */
  synchronized boolean mayAsk() {
    return queue.stream().noneMatch(Pending::isQuestion);
  }

  /** The unit has replied; false if the reply does not fit the next command in the queue. */
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

  /** Human-readable name of a command whose reply is overdue; empty if there is none. */
  synchronized String overdue(Duration patience) {
    Pending first = queue.peek();
    return first != null && ticker.nanos() - first.sentNanos() > patience.toNanos()
        ? first.command()
        : "";
  }

  /** Discards all expected replies. */
  synchronized void forget() {
    queue.clear();
  }
}
