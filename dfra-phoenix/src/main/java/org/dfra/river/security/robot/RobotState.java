package org.dfra.river.security.robot;

import java.io.IOException;
import java.nio.file.Path;
import java.security.SecureRandom;
import org.dfra.core.policy.ConfirmationRequests;
import org.dfra.core.policy.Confirmations;
import org.dfra.core.policy.PolicyFacts;
import org.dfra.module.Module;
import org.dfra.river.identity.FlooredClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What a process of a robot needs for decisions by the policy, besides the policy: facts and
 * confirmations. It shares both with the other processes of the robot.
 */
public final class RobotState {

  /** The folder in the state folder. It is not a part of the identity, which is replaced. */
  public static final String FOLDER = "policy-state";

  private static final Logger LOG = LoggerFactory.getLogger(RobotState.class);

  private static final String REQUESTS = "requests";

  private final FlooredClock clock;
  private final FactFile file;
  private final RobotFacts facts;
  private final PositionSources sources;
  private final ConfirmationRequests requests;
  private final RequestFiles shared;
  private volatile boolean isPositionNeeded;
  private String fault = ""; // confined to the thread of look

  /**
   * @param state the state folder
   * @param clock the robot's
   * @param onRequest called when a call waits for a confirmation, so that {@link #look} is called
   *     soon; it returns at once
   */
  public RobotState(Path state, FlooredClock clock, Runnable onRequest) {
    Path folder = state.resolve(FOLDER);
    this.clock = clock;
    this.file = new FactFile(folder);
    this.facts = new RobotFacts(folder, file, clock, System::nanoTime);
    this.sources = new PositionSources(facts);
    this.requests = new ConfirmationRequests(System::nanoTime, new SecureRandom(), onRequest);
    this.shared = new RequestFiles(folder.resolve(REQUESTS), System::nanoTime);
  }

  /** For the guard. */
  public PolicyFacts facts() {
    return facts;
  }

  /** For the guard. */
  public Confirmations confirmations() {
    return requests;
  }

  /**
   * Takes the robot's position from a module of this process, if it knows it.
   *
   * @return ends that
   */
  public AutoCloseable offerPosition(Module module) {
    sources.add(module);
    return () -> sources.remove(module);
  }

  /**
   * Looks at what other processes have changed. For one thread.
   *
   * @param needsPosition whether a rule of the policy in force needs the robot's position
   * @return whether requests wait, whose answers may come at any moment
   */
  public boolean look(boolean needsPosition) {
    isPositionNeeded = needsPosition;
    facts.look(needsPosition);
    sources.look(needsPosition);
    try {
      boolean isAwaited = shared.exchange(requests);
      fault = "";
      return isAwaited;
    } catch (IOException e) {
      String reason = String.valueOf(e);
      if (!reason.equals(fault)) { // it is tried several times a second
        LOG.error("Calls cannot be confirmed: {}", reason);
        fault = reason;
      }
      return false;
    }
  }

  /** This process's part of what operators call. */
  PolicyControl control() {
    return new PolicyControlService(
        file, shared, clock, () -> facts.position().orElse(null), () -> isPositionNeeded);
  }
}
