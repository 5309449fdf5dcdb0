package org.dfra.river.identity;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.lang.reflect.Method;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;

/**
 * The delegations in the folder of an identity, {@code *.delegation}. Commands to the robots that
 * they name carry them; nothing else does: reading, listening and stopping need no one else's
 * right. Thread-safe.
 */
public final class StoredDelegations implements OutgoingCredentials {

  /** The end of their files' names. */
  public static final String SUFFIX = ".delegation";

  /** So many files are read; there is one for each member who has delegated. */
  private static final int MAX_FILES = 64;

  private static final System.Logger LOG = System.getLogger(StoredDelegations.class.getName());

  private final Path folder;
  private final String fingerprint;
  private final Predicate<Method> commands;
  private final InstantSource clock;
  private volatile List<Stored> all = List.of();
  private Map<Path, List<Object>> states = Map.of(); // used by the thread that reloads only

  /** One, with the bytes that calls carry. */
  private record Stored(Delegation delegation, byte[] bytes) {}

  /**
   * @param credentials of the identity in the folder
   * @param commands which methods make a robot act
   */
  public StoredDelegations(
      Path folder, TeamCredentials credentials, Predicate<Method> commands, InstantSource clock) {
    this.folder = folder;
    this.fingerprint = Delegation.fingerprint(credentials.certificate());
    this.commands = commands;
    this.clock = clock;
  }

  /** The name of the file for what a member has delegated. */
  public static String fileName(Member principal) {
    return principal.role().text() + "-" + principal.name() + SUFFIX;
  }

  /**
   * A file in the folder of an identity.
   *
   * @param delegation what it contains; null if that is no delegation
   * @param fault why it is of no use to the member there, in a sentence; empty if it is of use
   *     until it expires
   */
  public record Filed(Path file, @Nullable Delegation delegation, String fault) {

    private static Filed read(Path file, String fingerprint) {
      try {
        Delegation read = Delegation.parse(SecurityFiles.read(file), file.toString());
        String fault =
            read.fingerprint().equals(fingerprint)
                ? ""
                : file + " is for a certificate of " + read.bearer() + " that is not the one here";
        return new Filed(file, read, fault);
      } catch (IdentityException e) {
        return new Filed(file, null, String.valueOf(e.getMessage()));
      }
    }
  }

  /**
   * The delegations in a folder, in the order of their files' names.
   *
   * @param credentials of the identity in the folder
   * @throws IdentityException if the folder cannot be listed
   */
  public static List<Filed> list(Path folder, TeamCredentials credentials)
      throws IdentityException {
    String fingerprint = Delegation.fingerprint(credentials.certificate());
    return files(folder).stream().map(each -> Filed.read(each, fingerprint)).toList();
  }

  private static List<Path> files(Path folder) throws IdentityException {
    List<Path> found = new ArrayList<>();
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + SUFFIX)) {
      for (Path each : files) {
        if (found.size() < MAX_FILES) {
          found.add(each);
        }
      }
    } catch (NoSuchFileException e) {
      return List.of();
    } catch (IOException e) {
      throw new IdentityException(folder + " cannot be listed (" + e + ")", e);
    }
    found.sort(Comparator.naturalOrder());
    return found;
  }

  /**
   * Reads them again if their files have changed. One that cannot be read is left out, and the log
   * says why. Not thread-safe.
   */
  public void reload() {
    try {
      Map<Path, List<Object>> now = new HashMap<>();
      for (Path each : files(folder)) {
        now.put(each, List.of(Files.getLastModifiedTime(each), Files.size(each)));
      }
      if (!now.equals(states)) {
        states = now;
        all = read(now.keySet().stream().sorted().toList());
      }
    } catch (IdentityException | IOException e) { // it is replaced just now
      LOG.log(Level.DEBUG, "Delegations are read later.", e);
    }
  }

  private List<Stored> read(List<Path> files) {
    List<Stored> read = new ArrayList<>();
    for (Path each : files) {
      Filed filed = Filed.read(each, fingerprint);
      @Nullable Delegation delegation = filed.delegation();
      if (delegation != null && filed.fault().isEmpty()) {
        read.add(new Stored(delegation, delegation.bytes()));
      } else {
        LOG.log(Level.WARNING, filed.fault());
      }
    }
    return List.copyOf(read);
  }

  /** The one that lasts longest of those that count for the server. */
  @Override
  public byte @Nullable [] of(Method method, Member server) {
    List<Stored> now = all;
    if (now.isEmpty() || server.role() != MemberRole.ROBOT || !commands.test(method)) {
      return null;
    }
    Instant time = clock.instant();
    @Nullable Stored best = null;
    for (Stored each : now) {
      Delegation delegation = each.delegation();
      if (delegation.robots().contains(server.name())
          && !time.isAfter(delegation.until())
          && (best == null || delegation.until().isAfter(best.delegation().until()))) {
        best = each;
      }
    }
    return best == null ? null : best.bytes();
  }
}
