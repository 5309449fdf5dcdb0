package org.dfra.recruit.experiment;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.core.lease.LeaseBook;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.transport.LateScheduler;
import org.dfra.recruit.transport.Passage;
import org.dfra.recruit.transport.SimulatedNetwork;
import org.dfra.recruit.transport.VirtualTime;
import org.dfra.time.Scheduler;

/** A simulated network in virtual time. Confined to the thread of its run. */
final class SimulatedVenue implements Venue {

  private static final Instant BEGIN = Instant.parse("2026-11-21T00:00:00Z");

  private final VirtualTime time = new VirtualTime(BEGIN);
  private final Scheduler timers;
  private final SimulatedNetwork network;

  SimulatedVenue(Cell cell, Plan plan, long seed) {
    this.timers = new LateScheduler(time, plan.timers(), Seeds.stream(seed, Seeds.TIMERS));
    this.network =
        new SimulatedNetwork(
            time,
            Passage.of(
                plan.losses().losing(cell.loss(), Seeds.stream(seed, Seeds.LOSSES)),
                plan.delay(),
                Seeds.stream(seed, Seeds.DELAYS)));
  }

  @Override
  public Scheduler time() {
    return timers;
  }

  @Override
  public Agent join(Member member) {
    String name = member.name();
    LeaseBook leases =
        new LeaseBook(name + "/agent", LeaseTerms.USUAL, time, timers, clients -> {});
    Recruiter agent =
        new Recruiter(
            name,
            member.settings(),
            member.strategy(),
            member.mode(),
            new RecruiterPorts(network.port(name), member.body(), leases, time, timers),
            member.listener(),
            Optional.empty());
    network.join(name, member.percepts(), agent::receive);
    agent.start();
    return new Agent() {
      @Override
      public void help(HelpCall call) {
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
  public void open() {
    // who has joined is known
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
    // its time stands still
  }
}
