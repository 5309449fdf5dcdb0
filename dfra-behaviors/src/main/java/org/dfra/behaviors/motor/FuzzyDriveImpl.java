package org.dfra.behaviors.motor;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dfra.behaviors.motor.WaypointRules.Answer;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SchemaImpl;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.module.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.MotorSchemaAttributes;

/**
 * Drives by the rules of a {@code .fis} file; see {@link WaypointRules}. It keeps nothing from one
 * question to the next, and tells every answer.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code system_file}: the file, required
 *   <li>{@code max_speed}: metres per second that {@code tr} = 1 is, 0.01 to 10; default 0.7
 *   <li>{@code max_turn_rate}: radians per second that {@code rv} = 1 is, 0.01 to 10; default 1
 * </ul>
 */
public final class FuzzyDriveImpl extends SchemaImpl implements FuzzyDrive {

  private final WaypointRules rules; // guarded by itself
  private final double maxSpeed;
  private final double maxTurnRate;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @throws org.dfra.core.config.ConfigurationException if the file is not what it should be
   */
  public FuzzyDriveImpl(ModuleContext context) {
    super(
        context,
        "drives towards a heading and around obstacles by fuzzy rules",
        "DFRA",
        "1",
        List.of("DriveAdvice"));
    this.rules = new WaypointRules(Path.of(settings().text("system_file")));
    this.maxSpeed = settings().number("max_speed", 0.7, 0.01, 10);
    this.maxTurnRate = settings().number("max_turn_rate", 1, 0.01, 10);
  }

  @Override
  protected List<? extends Attributes> furtherAttributes() {
    return List.of(new MotorSchemaAttributes("Velocity", rules.method(), rules.size()));
  }

  @Override
  protected void onStart() {
    super.onStart();
    become(Readiness.READY);
  }

  @Override
  public DriveAdvice advise(Clearance clearance, HeadingPercept heading) {
    Answer answer;
    synchronized (rules) {
      answer = rules.answer(clearance, heading);
    }
    Instant older =
        clearance.measured().isBefore(heading.measured())
            ? clearance.measured()
            : heading.measured();
    DriveAdvice advice =
        new DriveAdvice(
            older,
            new Velocity(answer.speed() * maxSpeed, answer.turn() * maxTurnRate),
            answer.reason(),
            answer.strength());
    tell(advice);
    return advice;
  }
}
