package org.dfra.experiments.recruit.embedded;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.dfra.experiments.recruit.simulation.ExperimentEnvironment;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.ExperimentPlan;
import org.dfra.experiments.recruit.simulation.Seeds;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.transport.Transport;
import org.dfra.recruit.transport.Transport.ForwardingTransport;
import org.dfra.recruit.transport.Transport.LossyTransport;
import org.dfra.time.Scheduler;

/**
 * A run over real JERI: the agents of an {@link EmbeddedTeam} exchange messages by remote events
 * over the loopback. The sender loses messages, by the same random numbers as in the simulated
 * network.
 *
 * <p>Time runs faster than real time, for agents, leases and robots alike; the delays of River and
 * of the machine are real, so they are longer in the scaled time.
 */
final class EmbeddedEnvironment implements ExperimentEnvironment {

  private static final int HEAD = 300; // its random numbers
  private static final double LONGEST_HEAD = 0.5; // of a period

  private final EmbeddedTeam team;
  private final Consumer<EmbeddedTeam> giveBack;
  private final LossModel loss;
  private final LossyTransport.MessageCounter count = new LossyTransport.MessageCounter();
  private final MessageDelays.NetworkDelays times;
  private final Duration head;

  /**
   * @param team for exclusive use by this run
   * @param giveBack receives it after the run
   */
  EmbeddedEnvironment(
      ExperimentCell cell,
      ExperimentPlan plan,
      long seed,
      EmbeddedTeam team,
      Consumer<EmbeddedTeam> giveBack,
      MessageDelays all) {
    this.team = team;
    this.giveBack = giveBack;
    this.loss = plan.losses().losing(cell.loss(), Seeds.random(seed, Seeds.LOSSES));
    this.times = all.newNetwork();
    team.timers().setDelayListener(all::addTimerDelay);
    double share = LONGEST_HEAD * Seeds.random(seed, HEAD).nextDouble();
    this.head = Duration.ofNanos((long) (share * plan.period().toNanos()));
  }

  @Override
  public Scheduler time() {
    return team.timers();
  }

  @Override
  public AgentHandle addAgent(AgentSpec member) throws Exception {
    FieldAgent agent = team.agent(member.name(), member.percepts());
    agent.join(
        member,
        new LossyTransport(new Stamped(agent.transport()), loss, count),
        envelope -> times.came(member.name(), envelope));
    return agent;
  }

  /** Records when messages are sent that are not lost. */
  private final class Stamped extends ForwardingTransport {

    Stamped(Transport real) {
      super(real);
    }

    @Override
    public void send(String robot, MessageEnvelope envelope) {
      times.sent(robot, envelope);
      delegate().send(robot, envelope);
    }

    @Override
    public void broadcast(String percept, MessageEnvelope envelope) {
      capableRobots(percept).forEach(robot -> send(robot, envelope));
    }
  }

  @Override
  public void awaitConnected() throws Exception {
    team.await();
    advance(head); // runs that start together do not call together
  }

  @Override
  public void advance(Duration span) throws InterruptedException {
    TimeUnit.NANOSECONDS.sleep((long) (span.toNanos() / team.speed()));
  }

  @Override
  public long transmissions() {
    return count.transmissions();
  }

  @Override
  public long receptions() {
    return count.receptions();
  }

  @Override
  public void close() {
    team.endRun();
    giveBack.accept(team);
  }
}
