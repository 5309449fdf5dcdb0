package org.dfra.experiments.recruit.simulation;

import java.time.Duration;
import java.util.Set;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.agent.RobotPort;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.time.Scheduler;

/** The environment of a run: its time, and the network with its agents. */
public interface ExperimentEnvironment extends AutoCloseable {

  /** Creates an environment for a run. */
  @FunctionalInterface
  interface Factory {

    /**
     * Creates an environment without agents.
     *
     * @param seed of the run; it seeds all random numbers
     * @throws Exception if it cannot be created
     */
    ExperimentEnvironment create(ExperimentCell cell, ExperimentPlan plan, long seed)
        throws Exception;
  }

  /**
   * The specification of a robot's agent.
   *
   * @param name of the robot
   * @param percepts that it declares it can observe
   */
  record AgentSpec(
      String name,
      Set<String> percepts,
      RobotPort body,
      RecruitmentStrategy strategy,
      MessageMode mode,
      RecruitmentSettings settings,
      RecruiterListener listener) {

    public AgentSpec {
      percepts = Set.copyOf(percepts);
    }
  }

  /** The handle of an agent. */
  interface AgentHandle {

    /** As {@link org.dfra.agent.RecruitmentAgent#callForHelp}. */
    void callForHelp(HelpCall call);

    /** Cancels the call. */
    void release();

    /** Its status. */
    RecruitmentStatus status();
  }

  /** The time of agents and robots. */
  Scheduler time();

  /**
   * Adds the agent of a robot.
   *
   * @throws Exception if it cannot be added
   */
  AgentHandle addAgent(AgentSpec member) throws Exception;

  /**
   * Returns when all added agents have discovered each other.
   *
   * @throws Exception if they do not
   */
  void awaitConnected() throws Exception;

  /** Advances the time. */
  void advance(Duration span) throws InterruptedException;

  /** Number of transmissions, a broadcast counted once. */
  long transmissions();

  /** The same, a broadcast counted once per receiver. */
  long receptions();

  /** Ends all agents. */
  @Override
  void close() throws Exception;
}
