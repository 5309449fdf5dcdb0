package org.dfra.core.module;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.flow.perceptual.Percept;
import org.dfra.flow.perceptual.PerceptualSchema;
import org.dfra.persona.Attributes;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Base of every perceptual schema. It serves while its percepts come, and says so when they do not,
 * and which module that it is to listen to is not there.
 *
 * <p>Parameter {@code longest_age}: seconds that a percept counts after it was measured, 0.05 to
 * 60; can be set while it runs.
 *
 * @param <P> what it keeps to answer by: what it perceives, or the percept that this rests on
 */
public abstract class PerceptualSchemaImpl<P extends Percept> extends SchemaImpl
    implements PerceptualSchema {

  /** Looks for an old percept each time this part of its longest age has passed. */
  private static final double LOOKS = 0.25;

  private final String percept;
  private final Scheduler time;
  private final LatestReading<P> latest; // set and lost under itself
  private volatile double longestAge;
  private volatile String lack;
  private @Nullable ScheduledTask ageCheck; // guarded by this
  private boolean over; // guarded by this

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param perceptType what it keeps to answer by
   * @param outputType what it perceives, by the simple name of its class
   * @param defaultMaxAge the default of {@code longest_age}, seconds
   */
  protected PerceptualSchemaImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      Class<P> perceptType,
      String outputType,
      double defaultMaxAge) {
    super(context, description, author, version, List.of(outputType));
    this.percept = perceptType.getSimpleName();
    this.lack = "it awaits its first " + percept;
    this.time = context.robotTime();
    this.longestAge = settings().number("longest_age", defaultMaxAge, 0.05, 60);
    this.latest =
        new LatestReading<>(this.percept, this, this::transitionTo, time::nanos, this::longestAge);
    parameterTable()
        .declareNumber(
            "longest_age",
            "how long a percept counts",
            NumberRange.of(0.05, 60, "s"),
            () -> longestAge,
            value -> longestAge = value);
  }

  /** What doubt is expressed by, how it perceives, and its rates, where it has any. */
  protected abstract PerceptualSchemaAttributes schemaAttributes();

  @Override
  protected List<? extends Attributes> additionalAttributes() {
    return List.of(schemaAttributes());
  }

  /** This counts from now on, unless it is too old already. */
  protected final void setPercept(P fresh) {
    Duration age = Duration.between(fresh.measured(), clock().instant());
    synchronized (latest) {
      latest.set(fresh, age.isNegative() ? Duration.ZERO : age);
    }
  }

  /** There is a new percept: it counts from now on, and is told. */
  protected final void publishPercept(P fresh) {
    setPercept(fresh);
    publish(fresh);
  }

  /**
   * What it keeps.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or none that still counts
   */
  protected final P percept() {
    return latest.get();
  }

  @Override
  protected void onStart() {
    super.onStart();
    latest.setMissing(lack);
    lookLater();
  }

  @Override
  protected void onClose() {
    synchronized (this) {
      over = true;
      if (ageCheck != null) {
        ageCheck.cancel();
      }
    }
    super.onClose();
  }

  private Duration longestAge() {
    return Duration.ofNanos(Math.round(longestAge * 1e9));
  }

  /** Looks whether percepts still come, often enough; on the scheduler's thread. */
  private void look() {
    synchronized (latest) {
      if (latest.isTooOld()) {
        lack = "no " + percept + " has come for " + LatestReading.seconds(longestAge());
        latest.markLost(lack);
      }
      latest.setMissing(lack + missingInput().map(missing -> "; " + missing).orElse(""));
    }
    lookLater();
  }

  private void lookLater() {
    synchronized (this) {
      if (!over) {
        ageCheck = time.after((long) (longestAge * LOOKS * 1e9), this::look);
      }
    }
  }
}
