package org.dfra.drivers.uav.mavlink;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
 * Resends commands until they are acknowledged: the command protocol of MAVLink.
 *
 * <pre>
 *   submit -&gt; QUEUED --first of its kind---------&gt; SENT --accepted, rejected-&gt; ended
 *                                                   |  ^
 *                             no answer for 0.7 s --+--+ resent, confirmation + 1, 4 times in all
 *                                                   |     then ended: timed out
 *                                                   +-- in progress --&gt; 10 s more, not resent
 * </pre>
 *
 * <p>An acknowledgement names only the kind of command, so one command of a kind is pending at a
 * time. A command that was sent twice may be acknowledged twice, and a cancelled command is
 * acknowledged too: such late acknowledgements are expected for a while and not assigned to the
 * next command. If a late acknowledgement is lost, the next command is resent once, which does no
 * harm.
 *
 * <p>Safe for use by several threads. The thread that calls {@link #acknowledge}, {@link
 * #resendDue} or {@link #lost} reports the outcomes, outside all locks. Source: mavlink.io,
 * "Command Protocol".
 */
final class CommandProtocol {

  /** How many times a command is sent, at most. */
  static final int MOST = 4;

  static final Duration ANSWER = Duration.ofMillis(700);
  private static final Duration PROGRESS = Duration.ofSeconds(10);

  /** Puts a command on the link. */
  @FunctionalInterface
  interface CommandSender {

    /**
     * @param times how many times it was sent before
     */
    void send(MavlinkCommand command, int times);
  }

  /** A pending command; guarded by the protocol's lock. */
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

  /** Commands of one kind. */
  private static final class CommandQueue {
    final ArrayDeque<Exchange> waiting = new ArrayDeque<>(); // the first is pending
    int expectedStrays;
    long straysExpectedUntil;
  }

  /** An outcome that is yet to be reported. */
  private record Ended(Exchange exchange, CommandResult result) {}

  private final Ticker ticker;
  private final CommandSender wire;
  private final ReentrantLock lock = new ReentrantLock(); // held during a write

  @GuardedBy("lock")
  private final Map<MavCmd, CommandQueue> queues = new EnumMap<>(MavCmd.class);

  @GuardedBy("lock")
  private boolean open;

  CommandProtocol(Ticker ticker, CommandSender wire) {
    this.ticker = ticker;
    this.wire = wire;
  }

  /** A vehicle has been found that can be commanded. */
  void open() {
    lock.lock();
    try {
      open = true;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Sends a command, immediately if no other of its kind is pending.
   *
   * @param outcome receives the outcome once, unless the command is cancelled
   * @return null if there is no vehicle: then nothing is sent and no outcome is reported
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
   * Runs a task while no other thread sends; waits up to a number of milliseconds of real time for
   * threads that send.
   *
   * @return false, without running the task, if another thread's write seems to be blocked
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

  /** Locks it; an interrupted thread gets it too if it is free. */
  static boolean tryLock(ReentrantLock lock, long millis) {
    try {
      return lock.tryLock() || lock.tryLock(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Cancels a command: it is not resent, and its outcome is not reported. */
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

  /** The vehicle has sent an acknowledgement. */
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

  @GuardedBy("lock")
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
   * Resends what is due.
   *
   * @return false, without sending, if another thread sends: its write may be blocked
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

  /** The link is lost: pending commands will not be acknowledged. */
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

  /** Removes a command and sends the next of its kind. */
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
