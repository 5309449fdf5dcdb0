package org.dfra.experiments.network;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.transport.DelayModel;
import org.dfra.recruit.transport.Transport;
import org.dfra.time.Scheduler;

/** A network of agents in one virtual machine. Confined to the thread that advances its time. */
public final class SimulatedNetwork {

  /** A connected agent. */
  private record Node(Set<String> percepts, Consumer<MessageEnvelope> inbox) {}

  private final Scheduler time;
  private final DeliveryModel passage;
  private final Map<String, Node> members = new LinkedHashMap<>();
  private final Map<String, List<String>> capable = new HashMap<>(); // by percept
  private long transmissions;
  private long receptions;
  private long delivered;

  /**
   * @param time for the arrival of messages
   * @param passage delivery model of each
   */
  public SimulatedNetwork(Scheduler time, DeliveryModel passage) {
    this.time = time;
    this.passage = passage;
  }

  /**
   * Connects an agent.
   *
   * @param percepts that it can observe
   * @param inbox receives its messages
   */
  public void join(String robot, Set<String> percepts, Consumer<MessageEnvelope> inbox) {
    members.put(robot, new Node(Set.copyOf(percepts), inbox));
    capable.clear();
  }

  /** Disconnects an agent: messages in transit to it are lost. */
  public void leave(String robot) {
    Node unused = members.remove(robot);
    capable.clear();
  }

  /** The transport of a robot; available before it is connected. */
  public Transport transport(String robot) {
    return new Port(robot);
  }

  /** Number of transmissions, a broadcast counted once. */
  public long transmissions() {
    return transmissions;
  }

  /** Number of transmissions, a broadcast counted once per receiver. */
  public long receptions() {
    return receptions;
  }

  /** Number of messages delivered, including duplicates. */
  public long delivered() {
    return delivered;
  }

  private void carry(String to, MessageEnvelope envelope) {
    receptions++;
    for (double after : passage.copyDelays(to, envelope)) {
      Scheduler.ScheduledTask unused =
          time.after(Math.round(after * 1e9), () -> deliver(to, envelope));
    }
  }

  private void deliver(String to, MessageEnvelope envelope) {
    Node member = members.get(to);
    if (member != null) {
      delivered++;
      member.inbox().accept(envelope);
    }
  }

  private List<String> whoCan(String percept) {
    return capable.computeIfAbsent(
        percept,
        wanted ->
            members.entrySet().stream()
                .filter(entry -> entry.getValue().percepts().contains(wanted))
                .map(Map.Entry::getKey)
                .toList());
  }

  private final class Port implements Transport {

    private final String self;

    Port(String self) {
      this.self = self;
    }

    @Override
    public List<String> capableRobots(String percept) {
      List<String> others = new ArrayList<>(whoCan(percept));
      others.remove(self);
      return others;
    }

    @Override
    public List<String> percepts() {
      Set<String> all = new TreeSet<>();
      members.forEach(
          (robot, member) -> {
            if (!robot.equals(self)) {
              all.addAll(member.percepts());
            }
          });
      return List.copyOf(all);
    }

    @Override
    public void send(String robot, MessageEnvelope envelope) {
      transmissions++;
      carry(robot, envelope);
    }

    @Override
    public void broadcast(String percept, MessageEnvelope envelope) {
      transmissions++;
      for (String robot : capableRobots(percept)) {
        carry(robot, envelope);
      }
    }
  }

  /** Models the delivery of a message to one robot. */
  @FunctionalInterface
  public interface DeliveryModel {

    double[] LOST = {};

    /** The delay of each copy, seconds; none where it is lost. */
    double[] copyDelays(String to, MessageEnvelope envelope);

    /** A message is lost, or delivered once. */
    static DeliveryModel of(LossModel loss, DelayModel delay, RandomGenerator random) {
      return (to, envelope) -> {
        double after = delay.next(random); // drawn for lost ones too: paired runs stay aligned
        return loss.loses(envelope.sender(), to) ? LOST : new double[] {after};
      };
    }
  }
}
