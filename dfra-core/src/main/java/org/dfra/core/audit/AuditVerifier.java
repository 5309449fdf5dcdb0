package org.dfra.core.audit;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeSet;
import org.dfra.core.audit.LineReader.RawLine;
import org.jspecify.annotations.Nullable;

/** Verifies the chains of all streams of a folder, line by line, without loading a file. */
public final class AuditVerifier {

  private static final int TRIES = 3;

  private AuditVerifier() {}

  /**
   * Verifies all streams.
   *
   * @param folder of the trail
   * @param heads what others keep; those of other owners are ignored
   * @return each stream that the folder has or a head names, ordered by name; empty if there is
   *     none
   * @throws IOException if a file cannot be read, a head is not signed by its certificate's key, or
   *     no head is of this folder's owners
   */
  public static List<VerifiedStream> verify(Path folder, List<KeptHead> heads) throws IOException {
    for (KeptHead each : heads) {
      if (!each.isSigned()) {
        throw new IOException(
            "the head of "
                + each.member()
                + " for stream "
                + each.head().stream()
                + " is not signed by the key of its certificate; get the heads from their keeper");
      }
    }
    for (int i = 1; ; i++) {
      try {
        return verifyOnce(folder, heads);
      } catch (NoSuchFileException e) { // its writer has just removed the oldest file
        if (i == TRIES) {
          throw new IOException("the file " + e.getMessage() + " was removed meanwhile", e);
        }
      }
    }
  }

  private static List<VerifiedStream> verifyOnce(Path folder, List<KeptHead> heads)
      throws IOException {
    SortedMap<String, List<TrailFile>> streams = TrailFile.in(folder);
    List<KeptHead> own = ofOwners(owners(streams), folder, heads);
    Set<String> names = new TreeSet<>(streams.keySet());
    own.forEach(each -> names.add(each.head().stream()));
    List<VerifiedStream> verified = new ArrayList<>();
    for (String name : names) {
      List<KeptHead> of = own.stream().filter(each -> each.head().stream().equals(name)).toList();
      List<TrailFile> files = streams.getOrDefault(name, List.of());
      verified.add(new StreamVerifier(name, files, of).verify());
    }
    return verified;
  }

  /**
   * Whose trail it is, as the first lines of the files say.
   *
   * @param folder of the trail
   * @return as heads name them; empty if there is no trail
   * @throws IOException if a file cannot be read
   */
  public static Set<String> owners(Path folder) throws IOException {
    return owners(TrailFile.in(folder));
  }

  /** Whose trail it is, as the first lines of the files say. */
  private static Set<String> owners(SortedMap<String, List<TrailFile>> streams) throws IOException {
    Set<String> owners = new HashSet<>();
    for (List<TrailFile> files : streams.values()) {
      for (TrailFile file : files) {
        try (LineReader reader = LineReader.open(file.path(), 0)) {
          @Nullable RawLine first = reader.next();
          @Nullable AuditLine line = first == null ? null : ChainLine.of(file, 1, first).line();
          if (line != null) { // the verification of the stream reports it otherwise
            line.header().ifPresent(header -> owners.add(header.owner()));
          }
        }
      }
    }
    return owners;
  }

  private static List<KeptHead> ofOwners(Set<String> owners, Path folder, List<KeptHead> heads)
      throws IOException {
    List<KeptHead> own =
        heads.stream().filter(each -> owners.contains(each.member().toString())).toList();
    if (own.isEmpty() && !heads.isEmpty()) {
      throw new IOException(
          "none of the heads is of "
              + (owners.isEmpty() ? "an owner that " + folder + " names" : owners)
              + ", but of "
              + new TreeSet<>(heads.stream().map(each -> each.member().toString()).toList())
              + "; name the heads of this trail's owner, or look whether the trail was replaced");
    }
    return own;
  }
}
