package org.dfra.directory;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.module.Module;
import org.dfra.persona.PersonaAttributes;
import org.dfra.text.PrintableText;

/**
 * A robot as the directory knows it. A snapshot.
 *
 * @param robot name of the robot, a {@linkplain PrintableText#word printable word}; another robot
 *     may have it on another host
 * @param host address or name of the computer it runs on, as its modules and its registrar report;
 *     empty if unknown
 * @param attributes its role, goals and limitations, if it has published them
 * @param modules its modules, by name
 * @param stale whether no reachable lookup service lists any of its modules any more
 * @param confirmed if it is stale, when a lookup service last listed it; else since when it has
 *     been known
 */
public record Persona(
    String robot,
    String host,
    Optional<PersonaAttributes> attributes,
    List<ModuleListing<Module>> modules,
    boolean stale,
    Instant confirmed) {

  public Persona {
    robot = PrintableText.word(robot);
    modules = List.copyOf(modules);
  }

  /** How long no reachable lookup service has listed it; zero if it is not stale. */
  public Duration staleness(Instant now) {
    Duration since = Duration.between(confirmed, now);
    return stale && !since.isNegative() ? since : Duration.ZERO;
  }
}
