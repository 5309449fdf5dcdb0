package org.dfra.recruit.transport;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.Letter;

/** Another transport that loses letters at their sender, and counts what is sent. */
public final class LossyTransport implements Transport {

  /** What was sent, by all transports that share it. */
  public static final class Count {

    private final AtomicLong transmissions = new AtomicLong();
    private final AtomicLong receptions = new AtomicLong();

    /** A broadcast counted once. */
    public long transmissions() {
      return transmissions.get();
    }

    /** A broadcast counted once for each that it was meant for. */
    public long receptions() {
      return receptions.get();
    }
  }

  private final Transport real;
  private final LossModel loss;
  private final Count count;

  /**
   * @param real brings what is not lost
   * @param loss is asked by one thread at a time among all transports that share it
   */
  public LossyTransport(Transport real, LossModel loss, Count count) {
    this.real = real;
    this.loss = loss;
    this.count = count;
  }

  @Override
  public List<String> capable(String percept) {
    return real.capable(percept);
  }

  @Override
  public List<String> ambiguous(String percept) {
    return real.ambiguous(percept);
  }

  @Override
  public List<String> percepts() {
    return real.percepts();
  }

  @Override
  public void send(String robot, Letter letter) {
    count.transmissions.incrementAndGet();
    carry(robot, letter);
  }

  @Override
  public void broadcast(String percept, Letter letter) {
    count.transmissions.incrementAndGet();
    capable(percept).forEach(robot -> carry(robot, letter));
  }

  private void carry(String robot, Letter letter) {
    count.receptions.incrementAndGet();
    boolean isLost;
    synchronized (loss) {
      isLost = loss.loses(letter.sender(), robot);
    }
    if (!isLost) {
      real.send(robot, letter);
    }
  }
}
