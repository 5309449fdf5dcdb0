package org.dfra.directory;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.text.PrintableText;

/**
 * A module as the directory knows it. An immutable snapshot.
 *
 * @param id the module's identity, the same after every restart
 * @param module the module, or its proxy
 * @param robot name of its robot, a {@linkplain PrintableText#word printable word}; empty if it has
 *     not published one
 * @param name name of the module, likewise; empty if it has not published one
 * @param attributes the attributes that it publishes
 * @param locality its network distance
 * @param stale whether no reachable lookup service lists it any more. It may still answer.
 * @param confirmed since when it has been known in this state, or, if it is stale, when a lookup
 *     service last listed it; the caller's clock, UTC
 * @param <M> the interface that was queried
 */
public record ModuleListing<M extends Module>(
    UUID id,
    M module,
    String robot,
    String name,
    List<Attributes> attributes,
    Locality locality,
    boolean stale,
    Instant confirmed) {

  public ModuleListing {
    robot = PrintableText.word(robot);
    name = PrintableText.word(name);
    attributes = List.copyOf(attributes);
  }

  /**
   * This listing once no reachable lookup service lists the module any more.
   *
   * @param lastListed when a lookup service last listed it; the caller's clock, UTC
   */
  public ModuleListing<M> asStale(Instant lastListed) {
    return new ModuleListing<>(id, module, robot, name, attributes, locality, true, lastListed);
  }

  /** The attributes of one kind, if the module has published any. */
  public <A extends Attributes> Optional<A> attributes(Class<A> kind) {
    for (int i = 0; i < attributes.size(); i++) { // called very often: no iterators
      Attributes each = attributes.get(i);
      if (kind.isInstance(each)) {
        return Optional.of(kind.cast(each));
      }
    }
    return Optional.empty();
  }

  /**
   * Address or name of the computer that it runs on, as it reports itself; empty if it has not. It
   * distinguishes robots of the same name.
   */
  public String host() {
    return attributes(ModuleAttributes.class).map(ModuleAttributes::host).orElse("");
  }

  /** How long no reachable lookup service has listed it; zero if it is not stale. */
  public Duration staleness(Instant now) {
    Duration since = Duration.between(confirmed, now);
    return stale && !since.isNegative() ? since : Duration.ZERO;
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
