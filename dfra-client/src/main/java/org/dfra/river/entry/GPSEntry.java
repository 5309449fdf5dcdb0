package org.dfra.river.entry;

import java.util.List;
import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of a satellite positioning receiver, see {@link GpsReceiverAttributes}. Null is
 * unknown, or any value in a template.
 */
@Mirrors(GpsReceiverAttributes.class)
public class GPSEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** Model, as the receiver reports it. */
  public @Nullable String model;

  /** Its serial number. */
  public @Nullable String serialNumber;

  /** Part number of its firmware. */
  public @Nullable String softwarePart;

  /** Version of its firmware. */
  public @Nullable String softwareVersion;

  /** How many satellites it can track at once. */
  public @Nullable Integer channels;

  /** The fix modes it supports, sorted. */
  public @Nullable List<String> fixModes;

  /** With every field null. */
  public GPSEntry() {}
}
