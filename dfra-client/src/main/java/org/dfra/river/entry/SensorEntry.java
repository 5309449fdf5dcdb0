package org.dfra.river.entry;

import java.util.List;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of a sensor, see {@link SensorAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(SensorAttributes.class)
public class SensorEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of the type of its readings. */
  public @Nullable String reading;

  /** Names of its operating modes, sorted. */
  public @Nullable List<String> modes;

  /** Slowest update rate, in hertz. */
  public @Nullable Double minRate;

  /** Fastest update rate, in hertz. */
  public @Nullable Double maxRate;

  /** Electric power, in watts. */
  public @Nullable Double power;

  /** Preconditions of its environment, sorted. */
  public @Nullable List<String> preconditions;

  /** With every field null. */
  public SensorEntry() {}
}
