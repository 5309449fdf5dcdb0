package org.dfra.event;

import java.io.Serializable;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;

/** An event that a module can publish. */
public sealed interface ModuleEvent extends Serializable {

  /** The module made a transition of {@link Readiness}. */
  record ReadinessChanged(Readiness from, Readiness to) implements ModuleEvent {}

  /** The module has a new reading; its type is the one that the module's interface returns. */
  record NewReading(Reading reading) implements ModuleEvent {}

  /** A parameter was set. */
  record ParameterChanged(String name, String text) implements ModuleEvent {}

  /** An incident was recorded in the module's history. */
  record IncidentRecorded(Incident incident) implements ModuleEvent {}
}
