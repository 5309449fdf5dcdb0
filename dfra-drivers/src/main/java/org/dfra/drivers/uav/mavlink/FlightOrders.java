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
final class FlightOrders {

  /** Is told how an order ended; by the reader thread, outside of all locks. */
  interface Listener {

    /**
     * @param order its name
     * @param step the step that was its last
     * @param result what became of that step; the order was done where it is accepted
     */
    void ended(String order, MavlinkCommand step, CommandResult result);
  }

  /** How long {@link #whileFree} waits for each lock, real time. */
  private static final long PATIENCE_MILLIS = 50;

  private final Listener listener;
  private final ReentrantLock lock = new ReentrantLock(); // held during a write
  private volatile @Nullable Order current; // written under lock
  private volatile String told = "none"; // written under lock

  /** It goes no further, whatever the answer to its last step is; not so the orders after it. */
  private volatile @Nullable Order calledOff;

  /** An order under way; all of it is guarded by the orders. */
  private static final class Order {
    final String name;
    final List<MavlinkCommand> steps;
    final CommandProtocol protocol;
    int at;
    CommandProtocol.@Nullable Exchange exchange;

    Order(String name, List<MavlinkCommand> steps, CommandProtocol protocol) {
      this.name = name;
      this.steps = steps;
      this.protocol = protocol;
    }

    MavlinkCommand step() {
      return steps.get(at);
    }
  }

  FlightOrders(Listener listener) {
    this.listener = listener;
  }

  /**
   * Gives an order; its first step is sent before the call returns.
   *
   * @return false where there is no vehicle to give it to
   */
  boolean begin(String name, List<MavlinkCommand> steps, CommandProtocol protocol) {
    lock.lock();
    try {
      forget();
      Order order = new Order(name, steps, protocol);
      current = order;
      told = name + " awaits its answer";
      return send(order);
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
  boolean whileFree(CommandProtocol protocol, Runnable task) {
    if (!CommandProtocol.isLockedWithin(lock, PATIENCE_MILLIS)) {
      return false;
    }
    try {
      return protocol.whileFree(PATIENCE_MILLIS, task);
    } finally {
      lock.unlock();
    }
  }

  /** Calls the order off that is under way, if any. */
  void forget() {
    lock.lock();
    try {
      @Nullable Order last = current;
      if (last != null && last.exchange != null) {
        last.protocol.callOff(last.exchange);
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
  boolean callOffMeanwhile(BooleanSupplier isDue) {
    @Nullable Order order = current;
    if (!isDue.getAsBoolean()) {
      return false;
    }
    calledOff = order;
    return true;
  }

  private boolean send(Order order) {
    order.exchange = order.protocol.begin(order.step(), result -> answered(order, result));
    if (order.exchange == null) {
      told = order.name + " could not be sent, since there is no vehicle";
      current = null;
      return false;
    }
    return true;
  }

  private void answered(Order order, CommandResult result) {
    MavlinkCommand step;
    lock.lock();
    try {
      if (current != order || calledOff == order) {
        return; // another has taken its place meanwhile, or is about to
      }
      step = order.step();
      if (result.isAccepted() && order.at + 1 < order.steps.size()) {
        order.at++;
        if (send(order)) {
          return;
        }
        result = CommandResult.LOST;
        step = order.step();
      }
      current = null;
      told = order.name + ": " + step.name() + " " + result;
    } finally {
      lock.unlock();
    }
    listener.ended(order.name, step, result);
  }

  /**
   * The order under way, or what became of the last one. Without the lock, which is held while an
   * order is written to the link.
   */
  String told() {
    return told;
  }
}
