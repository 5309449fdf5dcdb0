package org.dfra.drivers.uav.mavlink;

import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Sends flight commands to the vehicle step by step. A new command immediately replaces the old
 * one, which is not sent or resent any more, so that the old one never follows the new one.
 *
 * <p>Safe for use by several threads.
 */
final class FlightCommandSequencer {

  /** Receives the outcome of a command; called by the reader thread, outside all locks. */
  interface Listener {

    /**
     * @param commandName the command's name
     * @param step its last step
     * @param result result of that step; if it is accepted, the command was executed
     */
    void ended(String commandName, MavlinkCommand step, CommandResult result);
  }

  /** How long {@link #tryRunExclusively} waits for each lock, real time. */
  private static final long PATIENCE_MILLIS = 50;

  private final Listener listener;
  private final ReentrantLock lock = new ReentrantLock(); // held during a write
  private volatile @Nullable CommandSequence current; // written under lock
  private volatile String status = "none"; // written under lock

  /**
   * A cancelled sequence: it sends no further steps, whatever the answer to its last step. Later
   * sequences are unaffected.
   */
  private volatile @Nullable CommandSequence calledOff;

  /** A pending command; guarded by the sequencer's lock. */
  private static final class CommandSequence {
    final String name;
    final List<MavlinkCommand> steps;
    final CommandProtocol protocol;
    int at;
    CommandProtocol.@Nullable Exchange exchange;

    CommandSequence(String name, List<MavlinkCommand> steps, CommandProtocol protocol) {
      this.name = name;
      this.steps = steps;
      this.protocol = protocol;
    }

    MavlinkCommand step() {
      return steps.get(at);
    }
  }

  FlightCommandSequencer(Listener listener) {
    this.listener = listener;
  }

  /**
   * Starts a command; its first step is sent before the call returns.
   *
   * @return false if there is no vehicle
   */
  boolean start(String name, List<MavlinkCommand> steps, CommandProtocol protocol) {
    lock.lock();
    try {
      forget();
      CommandSequence sequence = new CommandSequence(name, steps, protocol);
      current = sequence;
      status = name + " awaits its answer";
      return send(sequence);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Runs a task that holds the locks of the sequencer and the protocol, if they are free or
   * released soon; commands that it starts do not wait for other threads.
   *
   * @return false, without running the task, if another thread's write seems to be blocked
   */
  boolean tryRunExclusively(CommandProtocol protocol, Runnable task) {
    if (!CommandProtocol.tryLock(lock, PATIENCE_MILLIS)) {
      return false;
    }
    try {
      return protocol.tryRunExclusively(PATIENCE_MILLIS, task);
    } finally {
      lock.unlock();
    }
  }

  /** Cancels the pending command, if any. */
  void forget() {
    lock.lock();
    try {
      @Nullable CommandSequence last = current;
      if (last != null && last.exchange != null) {
        last.protocol.cancel(last.exchange);
      }
      current = null;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Cancels the command that is being written, without waiting for that write; it sends no further
   * steps.
   *
   * @param isDue whether that command is not the next commander's; evaluated after the command has
   *     been read
   * @return the result of {@code isDue}; if false, nothing is cancelled
   */
  boolean tryCancelWithoutLock(BooleanSupplier isDue) {
    @Nullable CommandSequence sequence = current;
    if (!isDue.getAsBoolean()) {
      return false;
    }
    calledOff = sequence;
    return true;
  }

  private boolean send(CommandSequence sequence) {
    sequence.exchange =
        sequence.protocol.submit(sequence.step(), result -> answered(sequence, result));
    if (sequence.exchange == null) {
      status = sequence.name + " could not be sent, since there is no vehicle";
      current = null;
      return false;
    }
    return true;
  }

  private void answered(CommandSequence sequence, CommandResult result) {
    MavlinkCommand step;
    lock.lock();
    try {
      if (current != sequence || calledOff == sequence) {
        return; // another has replaced it meanwhile, or is about to
      }
      step = sequence.step();
      if (result.isAccepted() && sequence.at + 1 < sequence.steps.size()) {
        sequence.at++;
        if (send(sequence)) {
          return;
        }
        result = CommandResult.LOST;
        step = sequence.step();
      }
      current = null;
      status = sequence.name + ": " + step.name() + " " + result;
    } finally {
      lock.unlock();
    }
    listener.ended(sequence.name, step, result);
  }

  /**
   * The pending command, or the result of the last one. Does not use the lock, which is held while
   * a command is written to the link.
   */
  String status() {
    return status;
  }
}
