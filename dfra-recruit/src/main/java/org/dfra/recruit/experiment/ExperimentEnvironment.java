package org.dfra.recruit.experiment;

import java.time.Duration;
import java.util.Set;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.agent.RobotPort;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.transport.MessageMode;
import org.dfra.time.Scheduler;

/** Where a run takes place: its time, and the network with its agents. */
public interface ExperimentEnvironment extends AutoCloseable {

  /** Opens one for a run. */
  @FunctionalInterface
  interface Factory {

    /**
     * A venue where nobody is yet.
     *
     * @param seed of the run; what is drawn by chance is drawn by it
     * @throws Exception if there cannot be one
     */
    ExperimentEnvironment create(ExperimentCell cell, ExperimentPlan plan, long seed)
        throws Exception;
  }

  /**
   * A robot that is to have an agent.
   *
   * @param name of the robot
   * @param percepts that it says it can observe
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

  /** The agent of a member, for its own robot. */
  interface AgentHandle {

    /** As {@link org.dfra.agent.RecruitmentAgent#callForHelp}. */
    void callForHelp(HelpCall call);

    /** Gives the call up. */
    void release();

    /** What it is at. */
    RecruitmentStatus status();
  }

  /** The time that agents and robots live by. */
  Scheduler time();

  /**
   * Gives a robot its agent.
   *
   * @throws Exception if it cannot have one
   */
  AgentHandle addAgent(AgentSpec member) throws Exception;

  /**
   * Returns when all that have joined know each other.
   *
   * @throws Exception if they do not get to
   */
  void awaitConnected() throws Exception;

  /** Has a while pass. */
  void advance(Duration span) throws InterruptedException;

  /** How often something was sent, a broadcast counted once. */
  long transmissions();

  /** The same, a broadcast counted once for each that it was meant for. */
  long receptions();

  /** Ends all agents. */
  @Override
  void close() throws Exception;
}
