package org.dfra.behaviors.motor;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dfra.behaviors.motor.WaypointController.ControlOutput;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SchemaImpl;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.MotorSchemaAttributes;

/**
 * Drives by the rules of a {@code .fis} file; see {@link WaypointController}. It is stateless
 * between calls and publishes every result.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code system_file}: the file, required
 *   <li>{@code max_speed}: metres per second at {@code tr} = 1, 0.01 to 10; default 0.7
 *   <li>{@code max_yaw_rate}: radians per second at {@code rv} = 1, 0.01 to 10; default 1
 * </ul>
 */
public final class FuzzyDriveImpl extends SchemaImpl implements FuzzyDrive {

  private final WaypointController rules; // guarded by itself
  private final double maxSpeed;
  private final double maxYawRate;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @throws org.dfra.core.config.ConfigurationException if the file is invalid
   */
  public FuzzyDriveImpl(ModuleContext context) {
    super(
        context,
        "drives towards a heading and around obstacles by fuzzy rules",
        "DFRA",
        "1",
        List.of("DriveAdvice"));
    this.rules = new WaypointController(Path.of(settings().text("system_file")));
    this.maxSpeed = settings().number("max_speed", 0.7, 0.01, 10);
    this.maxYawRate = settings().number("max_yaw_rate", 1, 0.01, 10);
  }

  @Override
  protected List<? extends Attributes> additionalAttributes() {
    return List.of(new MotorSchemaAttributes("Velocity", rules.inferenceType(), rules.ruleCount()));
  }

  @Override
  protected void onStart() {
    super.onStart();
    transitionTo(Readiness.READY);
  }

  @Override
  public DriveAdvice advise(Clearance clearance, HeadingPercept heading) {
    ControlOutput answer;
    synchronized (rules) {
      answer = rules.evaluate(clearance, heading);
    }
    Instant older =
        clearance.measured().isBefore(heading.measured())
            ? clearance.measured()
            : heading.measured();
    DriveAdvice advice =
        new DriveAdvice(
            older,
            new Velocity(answer.speedFraction() * maxSpeed, answer.yawRateFraction() * maxYawRate),
            answer.reason(),
            answer.strength());
    publish(advice);
    return advice;
  }
}
