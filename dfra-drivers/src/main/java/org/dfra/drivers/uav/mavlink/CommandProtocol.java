package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.CommandAck;
import org.jspecify.annotations.Nullable;

/**
 * Sends commands until they are answered: the command protocol of MAVLink.
 *
 * <pre>
 *   begin --&gt; QUEUED --none of its sort before it--&gt; SENT --accepted, refused--&gt; ended
 *                                                   |  ^
 *                             no answer for 0.7 s --+--+ again, confirmation + 1, 4 times in all
 *                                                   |     then ended: unanswered
 *                                                   +-- in progress --&gt; 10 s more, not sent again
 * </pre>
 *
 * <p>An answer names the sort of command and not which one, so one of a sort is under way at a
 * time. A command that was sent twice may be answered twice, and one that was called off is
 * answered all the same: such strays are expected for a while and not taken for the answer to the
 * next. If one was lost itself, the next is sent once more, which does no harm.
 *
 * <p>Safe for use by several threads. Outcomes are told by the thread that calls {@link
 * #acknowledge}, {@link #resendDue} or {@link #lost}, outside of all locks. Source: mavlink.io,
 * "Command Protocol".
 */
final class CommandProtocol {

  /** How often a command is sent, at the most. */
  static final int MOST = 4;

  static final Duration ANSWER = Duration.ofMillis(700);
  private static final Duration PROGRESS = Duration.ofSeconds(10);

  /** Puts a command on the link. */
  @FunctionalInterface
  interface CommandSender {

    /**
     * @param times it was sent before
     */
    void send(MavlinkCommand command, int times);
  }

  /** A command on its way; all of it is guarded by the protocol. */
  static final class Exchange {
    private final MavlinkCommand command;
    private final Consumer<CommandResult> outcome;
    private int sent;
    private boolean inProgress;
    private long deadline;

    private Exchange(MavlinkCommand command, Consumer<CommandResult> outcome) {
      this.command = command;
      this.outcome = outcome;
    }
  }

  /** Commands of one sort. */
  private static final class CommandQueue {
    final ArrayDeque<Exchange> waiting = new ArrayDeque<>(); // the first is under way
    int expectedStrays;
    long straysExpectedUntil;
  }

  /** An end that is yet to be told. */
  private record Ended(Exchange exchange, CommandResult result) {}

  private final Ticker ticker;
  private final CommandSender wire;
  private final ReentrantLock lock = new ReentrantLock(); // held during a write
  private final Map<MavCmd, CommandQueue> queues = new EnumMap<>(MavCmd.class); // guarded by lock
  private boolean open; // guarded by lock

  CommandProtocol(Ticker ticker, CommandSender wire) {
    this.ticker = ticker;
    this.wire = wire;
  }

  /** There is a vehicle to be commanded. */
  void open() {
    lock.lock();
    try {
      open = true;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Sends a command, at once where no other of its sort is under way.
   *
   * @param outcome is told once how it ended, unless it is called off
   * @return null where there is no vehicle: nothing is sent then, and nothing told
   */
  @Nullable Exchange submit(MavlinkCommand command, Consumer<CommandResult> outcome) {
    lock.lock();
    try {
      if (!open) {
        return null;
      }
      Exchange exchange = new Exchange(command, outcome);
      CommandQueue line = queues.computeIfAbsent(command.id(), id -> new CommandQueue());
      line.waiting.add(exchange);
      if (line.waiting.size() == 1) {
        send(exchange);
      }
      return exchange;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Does something where no other thread sends, or stops to within so many milliseconds of real
   * time; no other thread does meanwhile.
   *
   * @return false, and nothing is done, where another thread's write seems to be held up
   */
  boolean tryRunExclusively(long millis, Runnable task) {
    if (!tryLock(lock, millis)) {
      return false;
    }
    try {
      task.run();
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Locks it, also for a thread that is interrupted, where it is free. */
  static boolean tryLock(ReentrantLock lock, long millis) {
    try {
      return lock.tryLock() || lock.tryLock(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** It is not sent again, and its end not told. */
  void cancel(Exchange exchange) {
    lock.lock();
    try {
      CommandQueue line = queues.get(exchange.command.id());
      if (line != null && line.waiting.contains(exchange)) {
        remove(line, exchange, exchange.sent);
      }
    } finally {
      lock.unlock();
    }
  }

  /** The vehicle has answered. */
  void acknowledge(CommandAck ack) {
    @Nullable Ended ended;
    lock.lock();
    try {
      ended = ended(ack);
    } finally {
      lock.unlock();
    }
    if (ended != null) {
      ended.exchange.outcome.accept(ended.result);
    }
  }

  private @Nullable Ended ended(CommandAck ack) {
    for (CommandQueue line : queues.values()) {
      @Nullable Exchange first = line.waiting.peek();
      int id = first == null ? -1 : MavlinkEncoder.number(first.command.id());
      if (first == null || id != ack.command()) {
        continue;
      }
      if (line.expectedStrays > 0 && ticker.nanos() - line.straysExpectedUntil < 0) {
        line.expectedStrays--;
        return null;
      }
      if (ack.result() == CommandResult.IN_PROGRESS) {
        first.inProgress = true;
        first.deadline = ticker.nanos() + PROGRESS.toNanos();
        return null;
      }
      remove(line, first, first.sent - 1);
      return new Ended(first, CommandResult.answered(ack.result()));
    }
    return null;
  }

  /**
   * Sends again what is due.
   *
   * @return false, and nothing is sent, where another thread sends: its write may be held up
   */
  boolean resendDue() {
    if (!lock.tryLock()) {
      return false;
    }
    List<Ended> ended = new ArrayList<>();
    try {
      for (CommandQueue line : queues.values()) {
        @Nullable Exchange first = line.waiting.peek();
        if (first == null || ticker.nanos() - first.deadline < 0) {
          continue;
        }
        if (first.sent < MOST && !first.inProgress) {
          send(first);
        } else {
          remove(line, first, first.sent);
          ended.add(new Ended(first, CommandResult.UNANSWERED));
        }
      }
    } finally {
      lock.unlock();
    }
    ended.forEach(each -> each.exchange.outcome.accept(each.result));
    return true;
  }

  /** There is no link any more; what was not answered yet never will be. */
  void lost() {
    List<Exchange> all = new ArrayList<>();
    lock.lock();
    try {
      open = false;
      queues.values().forEach(line -> all.addAll(line.waiting));
      queues.clear();
    } finally {
      lock.unlock();
    }
    all.forEach(each -> each.outcome.accept(CommandResult.LOST));
  }

  private void send(Exchange exchange) {
    exchange.deadline = ticker.nanos() + ANSWER.toNanos();
    wire.send(exchange.command, exchange.sent);
    exchange.sent++;
  }

  /** Lets the next of its sort go. */
  private void remove(CommandQueue line, Exchange exchange, int strays) {
    boolean wasFirst = line.waiting.peek() == exchange;
    line.waiting.remove(exchange);
    if (!wasFirst) {
      return;
    }
    line.expectedStrays = strays;
    line.straysExpectedUntil = ticker.nanos() + ANSWER.toNanos();
    @Nullable Exchange next = line.waiting.peek();
    if (next != null) {
      send(next);
    }
  }
}
