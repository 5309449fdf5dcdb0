package org.dfra.experiments.recruit.simulation;

import java.time.Duration;
import java.util.random.RandomGenerator;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.affect.Affect;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.loss.LossModel.IndependentLoss;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.strategy.StrategyRegistry;
import org.dfra.recruit.transport.DelayModel;

/**
 * The parameters common to every cell.
 *
 * @param calls number of calls of the aircraft in a run
 * @param period between calls; a call still pending is cancelled
 * @param settlingTime after the last call, for all robots to become idle
 * @param patience time for which a helper is searched
 * @param deadline within which a helper must arrive, for the call to count as a success
 * @param stay requested duration of help
 * @param settings timeouts of the protocol
 * @param shame the constants of the affective strategy
 * @param messageDelay of each message
 * @param timerDelay delay of agents' and robots' timers
 * @param losses creates the loss model
 */
public record ExperimentPlan(
    int calls,
    Duration period,
    Duration settlingTime,
    Duration patience,
    Duration deadline,
    Duration stay,
    RecruitmentSettings settings,
    ShameSettings shame,
    DelayModel messageDelay,
    DelayModel timerDelay,
    Losses losses) {

  /** Creates a loss model for a fraction lost. */
  @FunctionalInterface
  public interface Losses {
    LossModel losing(double share, RandomGenerator random);
  }

  /** Defaults: twelve calls, one every five minutes, for twenty seconds; independent losses. */
  public static final ExperimentPlan DEFAULT =
      new ExperimentPlan(
          12,
          Duration.ofSeconds(300),
          Duration.ofSeconds(300),
          Duration.ofSeconds(200),
          Duration.ofSeconds(240),
          Duration.ofSeconds(20),
          RecruitmentSettings.DEFAULT,
          ShameSettings.forField(ExperimentField.DIAGONAL, ExperimentRobot.SPEED),
          MeasuredDelays.ofMessages(),
          DelayModel.constant(0),
          IndependentLoss::new);

  /** The same with other constants of shame. */
  public ExperimentPlan with(ShameSettings other) {
    return copy(calls, period, settlingTime, other, messageDelay, timerDelay, losses);
  }

  /** The same with another delay. */
  public ExperimentPlan with(DelayModel other) {
    return with(other, timerDelay);
  }

  /** The same with other delays, of messages and of timers. */
  public ExperimentPlan with(DelayModel ofMessages, DelayModel ofTimers) {
    return copy(calls, period, settlingTime, shame, ofMessages, ofTimers, losses);
  }

  /** The same with other losses. */
  public ExperimentPlan with(Losses other) {
    return copy(calls, period, settlingTime, shame, messageDelay, timerDelay, other);
  }

  /** The same with another number of calls, period, and settling time. */
  public ExperimentPlan with(int fewer, Duration each, Duration after) {
    return copy(fewer, each, after, shame, messageDelay, timerDelay, losses);
  }

  private ExperimentPlan copy(
      int times,
      Duration each,
      Duration after,
      ShameSettings constants,
      DelayModel ofMessages,
      DelayModel ofTimers,
      Losses lost) {
    return new ExperimentPlan(
        times,
        each,
        after,
        patience,
        deadline,
        stay,
        settings,
        constants,
        ofMessages,
        ofTimers,
        lost);
  }

  RecruitmentStrategy strategy(String name, RandomGenerator random) {
    Affect affect = new Shame(shame);
    return StrategyRegistry.named(name, affect, random);
  }
}
