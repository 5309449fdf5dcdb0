package org.dfra.recruit.experiment;

import java.time.Duration;
import java.util.random.RandomGenerator;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.affect.Affect;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.ShameSettings;
import org.dfra.recruit.loss.IndependentLoss;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.strategy.StrategyRegistry;
import org.dfra.recruit.transport.DelayModel;
import org.dfra.recruit.transport.MeasuredDelays;

/**
 * What is the same in every cell.
 *
 * @param calls how many calls the aircraft makes in a run
 * @param period from call to call; one that is still under way is given up
 * @param settlingTime after the last call, for all to come to rest
 * @param patience for how long a helper is looked for
 * @param deadline within which one must have come, for the call to count as a success
 * @param stay for how long it is wanted
 * @param settings the time-outs
 * @param shame the constants of the affective strategy
 * @param messageDelay of each message
 * @param timerDelay by how much agents and robots are late where they wait for a time
 * @param losses makes what decides which are lost
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

  /** Makes a loss model that loses a share. */
  @FunctionalInterface
  public interface Losses {
    LossModel losing(double share, RandomGenerator random);
  }

  /** Twelve calls, one in five minutes, for twenty seconds; losses are independent. */
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
    return new ExperimentPlan(
        calls,
        period,
        settlingTime,
        patience,
        deadline,
        stay,
        settings,
        other,
        messageDelay,
        timerDelay,
        losses);
  }

  /** The same with another delay. */
  public ExperimentPlan with(DelayModel other) {
    return new ExperimentPlan(
        calls,
        period,
        settlingTime,
        patience,
        deadline,
        stay,
        settings,
        shame,
        other,
        timerDelay,
        losses);
  }

  /** The same with other delays, of messages and of timers. */
  public ExperimentPlan with(DelayModel ofMessages, DelayModel ofTimers) {
    return new ExperimentPlan(
        calls,
        period,
        settlingTime,
        patience,
        deadline,
        stay,
        settings,
        shame,
        ofMessages,
        ofTimers,
        losses);
  }

  /** The same with other losses. */
  public ExperimentPlan with(Losses other) {
    return new ExperimentPlan(
        calls,
        period,
        settlingTime,
        patience,
        deadline,
        stay,
        settings,
        shame,
        messageDelay,
        timerDelay,
        other);
  }

  /** The same with so many calls, one in that while, and that while after the last. */
  public ExperimentPlan with(int fewer, Duration each, Duration after) {
    return new ExperimentPlan(
        fewer,
        each,
        after,
        patience,
        deadline,
        stay,
        settings,
        shame,
        messageDelay,
        timerDelay,
        losses);
  }

  RecruitmentStrategy strategy(String name, RandomGenerator lot) {
    Affect affect = new Shame(shame);
    return StrategyRegistry.named(name, affect, lot);
  }
}
