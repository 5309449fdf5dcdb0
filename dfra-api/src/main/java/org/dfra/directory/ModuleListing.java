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
 * A module as the directory knows it. A snapshot: it does not change any more.
 *
 * @param id the module's identity, the same after every restart
 * @param module the module, or its proxy
 * @param robot name of its robot, a {@linkplain PrintableText#word printable word}; empty where it
 *     has not told
 * @param name name of the module, likewise; empty where it has not told
 * @param attributes what it says of itself
 * @param locality how far away it is
 * @param stale whether nobody vouches for it any more: every lookup service that knew it is out of
 *     reach. It may still answer.
 * @param confirmed since when it is known as it is here, or, where it is stale, when somebody last
 *     vouched for it; the asker's clock, UTC
 * @param <M> the interface that it was asked for by
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

  /** The attributes of one kind, if the module has told any. */
  public <A extends Attributes> Optional<A> attributes(Class<A> kind) {
    for (int i = 0; i < attributes.size(); i++) { // asked very often: no iterators
      Attributes each = attributes.get(i);
      if (kind.isInstance(each)) {
        return Optional.of(kind.cast(each));
      }
    }
    return Optional.empty();
  }

  /**
   * Address or name of the computer that it runs on, as it says itself; empty where it has not.
   * Robots of one name differ by it.
   */
  public String host() {
    return attributes(ModuleAttributes.class).map(ModuleAttributes::host).orElse("");
  }

  /** How long nobody has vouched for it; zero where it is not stale. */
  public Duration staleness(Instant now) {
    Duration since = Duration.between(confirmed, now);
    return stale && !since.isNegative() ? since : Duration.ZERO;
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
