package org.dfra.recruit.transport;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.MessageEnvelope;

/**
 * Sends messages to other agents. A message may be lost without notice, late, duplicated or
 * reordered. Its methods do not block and do not call the agent back before they return.
 */
public interface Transport {

  /**
   * Names of the other robots whose agents declare the percept, as far as is known. A name of
   * several robots is omitted: see {@link #ambiguousNames}.
   */
  List<String> capableRobots(String percept);

  /**
   * The reasons why nothing is sent to some robots that declare the percept: each name of several
   * robots, in a clause with their hosts. Empty where all names are unique.
   */
  default List<String> ambiguousNames(String percept) {
    return List.of();
  }

  /** Every percept that another robot declares, in alphabetical order. */
  List<String> percepts();

  /**
   * Sends to one robot. The message is lost where several robots have that name, so no other robot
   * gets it.
   */
  void send(String robot, MessageEnvelope envelope);

  /**
   * Sends to all robots that can observe the percept, with one transmission where the network
   * supports it.
   */
  void broadcast(String percept, MessageEnvelope envelope);

  /** Transmission of a message to all. */
  enum MessageMode {
    /** One transmission that all receive. */
    BROADCAST,
    /** One transmission to each receiver. */
    UNICAST
  }

  /** Wraps a transport, and finds the same robots as it does; a subclass changes how it sends. */
  abstract class ForwardingTransport implements Transport {

    private final Transport delegate;

    /**
     * @param delegate finds the robots
     */
    protected ForwardingTransport(Transport delegate) {
      this.delegate = delegate;
    }

    @Override
    public final List<String> capableRobots(String percept) {
      return delegate.capableRobots(percept);
    }

    @Override
    public final List<String> ambiguousNames(String percept) {
      return delegate.ambiguousNames(percept);
    }

    @Override
    public final List<String> percepts() {
      return delegate.percepts();
    }

    /** The wrapped transport. */
    protected final Transport delegate() {
      return delegate;
    }
  }

  /** Wraps a transport; it drops messages at their sender, and counts transmissions. */
  final class LossyTransport extends ForwardingTransport {

    /** Transmissions of all transports that share it. */
    public static final class MessageCounter {

      private final AtomicLong transmissions = new AtomicLong();
      private final AtomicLong receptions = new AtomicLong();

      /** A broadcast counted once. */
      public long transmissions() {
        return transmissions.get();
      }

      /** A broadcast counted once per receiver. */
      public long receptions() {
        return receptions.get();
      }
    }

    private final LossModel loss;
    private final MessageCounter count;

    /**
     * @param delegate delivers messages that are not lost
     * @param loss called by one thread at a time among all transports that share it
     */
    public LossyTransport(Transport delegate, LossModel loss, MessageCounter count) {
      super(delegate);
      this.loss = loss;
      this.count = count;
    }

    @Override
    public void send(String robot, MessageEnvelope envelope) {
      count.transmissions.incrementAndGet();
      carry(robot, envelope);
    }

    @Override
    public void broadcast(String percept, MessageEnvelope envelope) {
      count.transmissions.incrementAndGet();
      capableRobots(percept).forEach(robot -> carry(robot, envelope));
    }

    private void carry(String robot, MessageEnvelope envelope) {
      count.receptions.incrementAndGet();
      boolean isLost;
      synchronized (loss) {
        isLost = loss.loses(envelope.sender(), robot);
      }
      if (!isLost) {
        delegate().send(robot, envelope);
      }
    }
  }
}
