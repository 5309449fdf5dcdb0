package org.dfra.experiments.recruit.embedded;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.DoubleConsumer;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.time.ScaledTime;
import org.dfra.recruit.river.RecruitmentAgentProxy;
import org.dfra.recruit.river.RecruitmentAgentServer;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.bootstrap.ServedModules;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.river.server.ModuleActivation;
import org.dfra.time.Scheduler;

/**
 * A lookup service and the agents of a team. The agents are served, join it, and discover each
 * other in it by their sensors. Proxies do not use the shortcut to an agent in the same JVM, but
 * call it like a remote one. One run at a time uses it.
 */
final class EmbeddedTeam implements AutoCloseable {

  private static final String HOST = "127.0.0.1";
  private static final Duration LEASE = Duration.ofSeconds(30); // of a registration, real time
  private static final Duration PATIENCE = Duration.ofSeconds(60); // real time

  private final ScaledTime time;
  private final DelayRecordingScheduler timers;
  private final ServedModules serving;
  private final Map<String, FieldAgent> agents = new LinkedHashMap<>();

  /**
   * Starts the lookup service without agents.
   *
   * @param speed seconds of the agents' time per real second
   */
  EmbeddedTeam(double speed) throws IOException {
    this.time = new ScaledTime(speed, Instant.now());
    this.timers = new DelayRecordingScheduler(time);
    this.serving =
        new ServedModules(
            "a team of agents", new EmbeddedRegistrar(HOST, 0, List.of(), LEASE, Map.of()).start());
  }

  /** Seconds of its agents' time per real second. */
  double speed() {
    return time.speed();
  }

  /** The timers of agents, leases and robots. */
  DelayRecordingScheduler timers() {
    return timers;
  }

  /** The agent of that robot; the first call starts to serve it. */
  FieldAgent agent(String robot, Set<String> percepts) throws Exception {
    FieldAgent known = agents.get(robot);
    if (known != null) {
      return known;
    }
    FieldAgent.AgentSlot slot =
        new FieldAgent.AgentSlot(percepts, time, timers, fresh -> agents.put(robot, fresh));
    UUID id = UUID.randomUUID();
    serving.serve(activation(robot, slot, id));
    FieldAgent made = Objects.requireNonNull(agents.get(robot), "made when it was served");
    LocalModuleRegistry.unregister(id, made); // otherwise calls would be local
    return made;
  }

  private ModuleActivation activation(String robot, FieldAgent.AgentSlot slot, UUID id) {
    ModuleDescription description =
        new ModuleDescription(
            robot,
            "agent",
            RecruitmentAgentServer.class.getName(),
            RecruitmentAgentProxy.class.getName(),
            FieldAgent.class.getName(),
            null,
            false,
            Parameters.of(robot + "/agent", Map.of(FieldAgent.SLOT, slot.reserve())),
            SourceLocation.CODE);
    return new ModuleActivation(
        description, id, HOST, List.of(), List.of(serving.registrar().locator()));
  }

  /** Returns when each agent has discovered all others. */
  void await() throws Exception {
    for (FieldAgent agent : agents.values()) {
      DemoAssertions.await(
          "that " + agent + " finds the others",
          PATIENCE,
          () -> agent.known().equals(agents.keySet()));
    }
  }

  /** Ends the run; the agents wait for another. */
  void endRun() {
    agents.values().forEach(FieldAgent::leave);
  }

  @Override
  public void close() throws IOException {
    serving.close();
  }

  /** A scheduler of scaled time that records the lateness of its tasks. */
  static final class DelayRecordingScheduler implements Scheduler {

    private final ScaledTime time;
    private volatile DoubleConsumer late = seconds -> {};

    DelayRecordingScheduler(ScaledTime time) {
      this.time = time;
    }

    /** Sets the listener for the lateness of each task, in real seconds. */
    void setDelayListener(DoubleConsumer listener) {
      late = listener;
    }

    @Override
    public long nanos() {
      return time.nanos();
    }

    @Override
    public ScheduledTask after(long nanos, Runnable task) {
      long due = time.nanos() + Math.max(0, nanos);
      return time.after(
          nanos,
          () -> {
            late.accept(Math.max(0, time.nanos() - due) / 1e9 / time.speed());
            MessageDelays.runTimed(task);
          });
    }

    @Override
    public Condition newCondition(ReentrantLock lock) {
      return time.newCondition(lock);
    }
  }
}
