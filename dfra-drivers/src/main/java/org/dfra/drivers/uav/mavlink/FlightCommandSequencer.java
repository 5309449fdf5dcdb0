package org.dfra.drivers.uav.mavlink;

import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/**
 * The order that the vehicle is being given, step by step. A new order takes the place of the old
 * one at once: of that nothing is sent any more, so that a repetition of it never comes after the
 * new one.
 *
 * <p>Safe for use by several threads.
 */
final class FlightCommandSequencer {

  /** Is told how an order ended; by the reader thread, outside of all locks. */
  interface Listener {

    /**
     * @param commandName its name
     * @param step the step that was its last
     * @param result what became of that step; the order was done where it is accepted
     */
    void ended(String commandName, MavlinkCommand step, CommandResult result);
  }

  /** How long {@link #tryRunExclusively} waits for each lock, real time. */
  private static final long PATIENCE_MILLIS = 50;

  private final Listener listener;
  private final ReentrantLock lock = new ReentrantLock(); // held during a write
  private volatile @Nullable CommandSequence current; // written under lock
  private volatile String status = "none"; // written under lock

  /** It goes no further, whatever the answer to its last step is; not so the orders after it. */
  private volatile @Nullable CommandSequence calledOff;

  /** An order under way; all of it is guarded by the orders. */
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
   * Gives an order; its first step is sent before the call returns.
   *
   * @return false where there is no vehicle to give it to
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
   * Does something where no other thread holds the orders or the protocol, or lets go of them soon;
   * no other thread does meanwhile, so orders that it begins wait for none.
   *
   * @return false, and nothing is done, where another thread's write seems to be held up
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

  /** Calls the order off that is under way, if any. */
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
   * The order that is just being written gets no further step; without waiting for that write.
   *
   * @param isDue whether that order is not the next commander's; asked when it has been looked at
   * @return what {@code isDue} says; nothing is called off where that is false
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
        return; // another has taken its place meanwhile, or is about to
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
   * The order under way, or what became of the last one. Without the lock, which is held while an
   * order is written to the link.
   */
  String status() {
    return status;
  }
}
