package org.dfra.experiments.recruit.simulation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.dfra.agent.HelpCall;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.experiments.network.SimulatedNetwork;
import org.dfra.experiments.network.SimulatedNetwork.DeliveryModel;
import org.dfra.experiments.recruit.simulation.ExperimentField.FieldPoint;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.strategy.Greedy;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.recruit.transport.VirtualTime;

/**
 * Measures the rate of messages between agents in one virtual machine, per second of real time,
 * with the simulated network. Every tenth agent calls for help repeatedly; the others answer.
 */
public final class MessageRate {

  /**
   * The result.
   *
   * @param delivered number of messages sent, delivered and handled
   * @param seconds of real time
   */
  public record Result(int agents, long delivered, double seconds) {

    /** Messages per second. */
    public double rate() {
      return delivered / seconds;
    }
  }

  private static final int CALLER_EVERY = 10;

  private final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
  private final SplittableRandom random = new SplittableRandom(1);
  private final SimulatedNetwork network =
      new SimulatedNetwork(
          time, DeliveryModel.of(LossModel.none(), MeasuredDelays.ofMessages(), random));
  private final List<Recruiter> callers = new ArrayList<>();
  private final int agents;

  private MessageRate(int agents) {
    this.agents = agents;
    for (int i = 0; i < agents; i++) {
      Recruiter agent = agent("robot" + i, i % CALLER_EVERY == 0);
      if (i % CALLER_EVERY == 0) {
        callers.add(agent);
      }
    }
  }

  private Recruiter agent(String name, boolean calls) {
    Set<String> percepts = calls ? Set.of() : Set.of("mine");
    FieldPoint begin = new FieldPoint(100 * random.nextDouble(), 100 * random.nextDouble());
    ExperimentRobot body = new ExperimentRobot(time, percepts, 1, random.split(), null, begin);
    Recruiter agent =
        new Recruiter(
            name,
            RecruitmentSettings.DEFAULT,
            new Greedy(),
            MessageMode.BROADCAST,
            new RecruiterPorts(
                network.transport(name),
                body,
                new LeaseRegistry(name, LeaseTerms.DEFAULT, time, time, clients -> {}),
                time,
                time),
            new RecruiterListener() {},
            Optional.empty());
    network.join(name, percepts, agent::receive);
    agent.start();
    return agent;
  }

  /**
   * Measures the rate.
   *
   * @param minutes of virtual time; each has a call of every caller
   */
  public static Result measure(int agents, int minutes) {
    MessageRate run = new MessageRate(agents);
    long begin = System.nanoTime();
    for (int i = 0; i < minutes; i++) {
      for (Recruiter caller : run.callers) {
        caller.release();
        caller.help(
            new HelpCall(
                "mine",
                ExperimentField.toEarth(new FieldPoint(50, 50)),
                Duration.ofSeconds(5),
                Duration.ofSeconds(50)));
      }
      run.time.advance(Duration.ofMinutes(1));
    }
    return new Result(run.agents, run.network.delivered(), (System.nanoTime() - begin) / 1e9);
  }
}
