package org.dfra.experiments.navigation;

import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.persona.PerceptualSchemaAttributes;

/**
 * A range filter that reports no obstacles: the negative control of the benchmark, in which robots
 * that meet do not avoid each other.
 */
public final class BlindRangeFilterImpl extends PerceptualSchemaImpl<Clearance>
    implements RangeFilter {

  private static final double FAR = 8; // metres

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public BlindRangeFilterImpl(ModuleContext context) {
    super(
        context,
        "reports a free clearance in all directions",
        "DFRA",
        "1",
        Clearance.class,
        "Clearance",
        0.5);
    String base = context.robot() + "/base_link";
    declareInput(
        RangeSensor.class,
        "range_sensor",
        RangeScan.class,
        (source, scan) -> publishPercept(new Clearance(scan.measured(), base, FAR, FAR, FAR)));
  }

  @Override
  protected PerceptualSchemaAttributes schemaAttributes() {
    return new PerceptualSchemaAttributes("Clearance", null, "none", null, null);
  }

  @Override
  public Clearance clearance() {
    return percept();
  }
}
