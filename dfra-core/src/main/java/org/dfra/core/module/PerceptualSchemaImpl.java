package org.dfra.core.module;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
 * Base of every perceptual schema. It serves while percepts are produced. Otherwise it reports that
 * none are produced and which input module is missing.
 *
 * <p>Parameter {@code max_age}: maximum age of a valid percept in seconds, 0.05 to 60; can be set
 * while it runs.
 *
 * @param <P> the percept that it stores to answer queries: its output, or the percept that its
 *     output is based on
 */
public abstract class PerceptualSchemaImpl<P extends Percept> extends SchemaImpl
    implements PerceptualSchema {

  /** Checks the percept's age with this fraction of the maximum age as period. */
  private static final double LOOKS = 0.25;

  private final String percept;
  private final Scheduler time;
  private final LatestReading<P> latest; // modified with its own lock held
  private volatile double longestAge;
  private volatile String lack;

  @GuardedBy("this")
  private @Nullable ScheduledTask ageCheck;

  @GuardedBy("this")
  private boolean over;

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param perceptType the percept that it stores
   * @param outputType its output type, by the simple name of its class
   * @param defaultMaxAge the default of {@code max_age}, seconds
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
    this.longestAge = settings().number("max_age", defaultMaxAge, 0.05, 60);
    this.latest =
        new LatestReading<>(this.percept, this, this::transitionTo, time::nanos, this::longestAge);
    parameterTable()
        .declareNumber(
            "max_age",
            "how long a percept counts",
            NumberRange.of(0.05, 60, "s"),
            () -> longestAge,
            value -> longestAge = value);
  }

  /** The kind of uncertainty, the method, and the detection rates, if it has any. */
  protected abstract PerceptualSchemaAttributes schemaAttributes();

  @Override
  protected List<? extends Attributes> additionalAttributes() {
    return List.of(schemaAttributes());
  }

  /** Stores a new percept, unless it is too old. */
  protected final void setPercept(P fresh) {
    Duration age = Duration.between(fresh.measured(), clock().instant());
    synchronized (latest) {
      latest.set(fresh, age.isNegative() ? Duration.ZERO : age);
    }
  }

  /** Stores and publishes a new percept. */
  protected final void publishPercept(P fresh) {
    setPercept(fresh);
    publish(fresh);
  }

  /**
   * The stored percept.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
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

  /** Checks periodically whether percepts still arrive; on the scheduler's thread. */
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
