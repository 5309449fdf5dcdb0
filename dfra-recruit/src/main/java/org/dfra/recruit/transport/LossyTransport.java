package org.dfra.recruit.transport;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.MessageEnvelope;

/** Wraps a transport; it drops messages at their sender, and counts transmissions. */
public final class LossyTransport implements Transport {

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

  private final Transport real;
  private final LossModel loss;
  private final MessageCounter count;

  /**
   * @param delegate delivers messages that are not lost
   * @param loss called by one thread at a time among all transports that share it
   */
  public LossyTransport(Transport delegate, LossModel loss, MessageCounter count) {
    this.real = delegate;
    this.loss = loss;
    this.count = count;
  }

  @Override
  public List<String> capableRobots(String percept) {
    return real.capableRobots(percept);
  }

  @Override
  public List<String> ambiguousNames(String percept) {
    return real.ambiguousNames(percept);
  }

  @Override
  public List<String> percepts() {
    return real.percepts();
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
      real.send(robot, envelope);
    }
  }
}
