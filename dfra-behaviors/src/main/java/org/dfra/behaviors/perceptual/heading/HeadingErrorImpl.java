package org.dfra.behaviors.perceptual.heading;

import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.flow.perceptual.HeadingError;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Publishes heading error and cross-track error to a line, from the robot's position estimator; see
 * {@link LineGuidance}.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code lookahead}: metres, 0.5 to 50; default 2.2
 *   <li>{@code position}: name of the estimator to use; default the first
 *   <li>{@code max_age}: as for every perceptual schema; default 0.5
 * </ul>
 */
public final class HeadingErrorImpl extends PerceptualSchemaImpl<PoseEstimate>
    implements HeadingError {

  private final LineGuidance guidance;
  private final String base;
  private volatile @Nullable LocalFrame frame; // of the last pose

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public HeadingErrorImpl(ModuleContext context) {
    super(
        context,
        "heading error and cross-track error to the planned leg",
        "DFRA",
        "1",
        PoseEstimate.class,
        "HeadingPercept",
        0.5);
    this.guidance = new LineGuidance(settings().number("lookahead", 2.2, 0.5, 50));
    this.base = context.robot() + "/base_link";
    declareInput(
        PositionEstimator.class,
        "position",
        PoseEstimate.class,
        (source, pose) -> setPercept(pose));
  }

  @Override
  protected PerceptualSchemaAttributes schemaAttributes() {
    return new PerceptualSchemaAttributes("HeadingPercept", null, "lookahead", null, null);
  }

  @Override
  public HeadingPercept towards(Leg leg) {
    PoseEstimate pose = percept();
    LocalFrame local = frame(pose.datum());
    LocalPosition from = local.toLocal(leg.from());
    LocalPosition to = local.toLocal(leg.to());
    HeadingPercept percept = guidance.towards(pose, from, to, base);
    publish(percept);
    return percept;
  }

  private LocalFrame frame(GeoPosition datum) {
    @Nullable LocalFrame last = frame;
    if (last == null || !last.datum().equals(datum)) {
      last = new LocalFrame(datum);
      frame = last;
    }
    return last;
  }
}
