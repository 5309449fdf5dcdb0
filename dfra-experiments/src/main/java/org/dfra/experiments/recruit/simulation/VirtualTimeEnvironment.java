package org.dfra.experiments.recruit.simulation;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.experiments.network.SimulatedNetwork;
import org.dfra.experiments.network.SimulatedNetwork.DeliveryModel;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.transport.VirtualTime;
import org.dfra.recruit.transport.VirtualTime.LateScheduler;
import org.dfra.time.Scheduler;

/** A simulated network in virtual time. Confined to the thread of its run. */
final class VirtualTimeEnvironment implements ExperimentEnvironment {

  private static final Instant BEGIN = Instant.parse("2026-11-21T00:00:00Z");

  private final VirtualTime time = new VirtualTime(BEGIN);
  private final Scheduler timers;
  private final SimulatedNetwork network;

  VirtualTimeEnvironment(ExperimentCell cell, ExperimentPlan plan, long seed) {
    this.timers = new LateScheduler(time, plan.timerDelay(), Seeds.random(seed, Seeds.TIMERS));
    this.network =
        new SimulatedNetwork(
            time,
            DeliveryModel.of(
                plan.losses().losing(cell.loss(), Seeds.random(seed, Seeds.LOSSES)),
                plan.messageDelay(),
                Seeds.random(seed, Seeds.DELAYS)));
  }

  @Override
  public Scheduler time() {
    return timers;
  }

  @Override
  public AgentHandle addAgent(AgentSpec member) {
    String name = member.name();
    LeaseRegistry leases =
        new LeaseRegistry(name + "/agent", LeaseTerms.DEFAULT, time, timers, clients -> {});
    Recruiter agent =
        new Recruiter(
            name,
            member.settings(),
            member.strategy(),
            member.mode(),
            new RecruiterPorts(network.transport(name), member.body(), leases, time, timers),
            member.listener(),
            Optional.empty());
    network.join(name, member.percepts(), agent::receive);
    agent.start();
    return new AgentHandle() {
      @Override
      public void callForHelp(HelpCall call) {
        agent.help(call);
      }

      @Override
      public void release() {
        agent.release();
      }

      @Override
      public RecruitmentStatus status() {
        return agent.status();
      }
    };
  }

  @Override
  public void awaitConnected() {
    // added agents are known at once
  }

  @Override
  public void advance(Duration span) {
    time.advance(span);
  }

  @Override
  public long transmissions() {
    return network.transmissions();
  }

  @Override
  public long receptions() {
    return network.receptions();
  }

  @Override
  public void close() {
    // its time no longer advances
  }
}
