package org.dfra.cli.lease;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.jspecify.annotations.Nullable;

/**
 * A lease on a module; the components as in {@link LeaseStatus}.
 *
 * @param module the module's path, {@code robot/name}
 * @param id its {@link LeaseHandle}, which is not secret
 * @param heldBy the modules of the process that holds it, one of which is the holder; none if no
 *     module is known to hold it
 * @param local whether its holder runs in the module's own JVM
 */
record LeaseView(
    String module,
    UUID id,
    LeaseRole holder,
    List<String> heldBy,
    boolean local,
    @Nullable String host,
    Instant since,
    Duration held,
    @Nullable Duration remaining) {

  LeaseView {
    heldBy = List.copyOf(heldBy);
  }

  static LeaseView of(String module, LeaseStatus lease) {
    return of(module, lease, List.of());
  }

  static LeaseView of(String module, LeaseStatus lease, List<String> heldBy) {
    return new LeaseView(
        module,
        lease.handle().value(),
        lease.role(),
        heldBy,
        lease.isLocal(),
        lease.host(),
        lease.grantedAt(),
        lease.age(),
        lease.remaining());
  }

  /** A prefix of its ID that distinguishes it from others. */
  String shortId() {
    return id.toString().substring(0, id.toString().indexOf('-'));
  }

  String hostInWords() {
    if (local) {
      return "its own JVM";
    }
    return host == null ? "not known" : host;
  }

  /** The holder: a module, or else the address from which the lease was requested. */
  String holderInWords() {
    if (local) {
      return "a module in its own JVM";
    }
    return heldBy.isEmpty() ? "a program at " + hostInWords() : String.join(" or ", heldBy);
  }

  String endInWords() {
    if (remaining == null) {
      return "with the module";
    }
    return "in " + Math.max(0, Math.round(remaining.toMillis() / 1e3)) + " s";
  }
}
