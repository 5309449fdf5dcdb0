package org.dfra.river.discovery;

import java.util.Collection;

/**
 * A lookup service that a {@link MulticastSearch} has found, whose lock guards the mutable fields.
 */
final class FoundRegistrar {

  final LocatedRegistrar registrar;
  final String host;
  Collection<String> groups; // guarded by the search, like the next fields
  long seenAt; // nanoseconds of the system, like the next field
  long checkedAt;
  boolean isBeingChecked;

  FoundRegistrar(LocatedRegistrar registrar, String host, Collection<String> groups, long now) {
    this.registrar = registrar;
    this.host = host;
    this.groups = groups;
    this.seenAt = now;
    this.checkedAt = now;
  }
}
