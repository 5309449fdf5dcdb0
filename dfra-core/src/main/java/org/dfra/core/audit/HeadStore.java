package org.dfra.core.audit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.state.StateStore;
import org.dfra.security.Member;
import org.jspecify.annotations.Nullable;

/**
 * The newest heads that a member has received from others, in a file. A head is only ever replaced
 * by a newer one of the same stream. Thread-safe.
 *
 * <p>How heads travel between members is not its concern: a transport calls {@link #keep} with what
 * it received, after it has checked that the certificate is of this team.
 */
public final class HeadStore {

  /** Most streams of one member. */
  public static final int MOST_STREAMS = 64;

  /** Most streams of all members. */
  public static final int MOST_HEADS = 1_024;

  /** What became of a head. */
  public enum Outcome {
    /** It is kept. */
    KEPT,
    /** A head with the same or a higher number is kept already. */
    KNOWN,
    /**
     * The kept head has the same number and another hash. Both are signed: this proves that the
     * trail was rewritten. The kept head stays.
     */
    CONTRADICTION,
    /** The certificate's key has not signed it. */
    NOT_SIGNED,
    /** There are too many streams already. */
    FULL
  }

  /** The member's text first: it names the owner of a trail. */
  private record Key(String member, String stream) implements Comparable<Key> {
    @Override
    public int compareTo(Key other) {
      int byMember = member.compareTo(other.member);
      return byMember != 0 ? byMember : stream.compareTo(other.stream);
    }
  }

  private final Path file;
  private final StateStore disk;

  @GuardedBy("this")
  private final Map<Key, KeptHead> heads = new TreeMap<>();

  private HeadStore(Path file, StateStore disk) {
    this.file = file;
    this.disk = disk;
  }

  /**
   * Opens a store.
   *
   * @param file the heads; created if missing, in a folder that becomes private
   * @throws IOException if the folder is not private, or the file is no store of heads
   */
  public static HeadStore open(Path file) throws IOException {
    Path absolute = file.toAbsolutePath();
    @Nullable Path folder = absolute.getParent();
    if (folder == null) {
      throw new IOException(file + " is a folder; name a file for the heads of audit trails");
    }
    PrivateFiles.requireFolder(folder);
    PrivateFiles.makeFile(absolute);
    HeadStore store = new HeadStore(absolute, StateStore.inFolder(folder));
    store.load(HeadCodec.read(absolute));
    return store;
  }

  private synchronized void load(List<KeptHead> all) {
    all.forEach(each -> heads.put(key(each), each));
  }

  private static Key key(KeptHead head) {
    return new Key(head.member().toString(), head.head().stream());
  }

  /**
   * Keeps a head if it is newer.
   *
   * @param certificate of the member that signed it, which the caller has checked
   * @throws IOException if it cannot be written; then the former head stays
   * @throws IllegalArgumentException if the certificate names no member
   */
  public synchronized Outcome keep(AuditHead head, X509Certificate certificate) throws IOException {
    KeptHead fresh = KeptHead.of(head, certificate);
    if (!fresh.isSigned()) {
      return Outcome.NOT_SIGNED;
    }
    @Nullable KeptHead known = heads.get(key(fresh));
    if (known == null && isFull(fresh.member())) {
      return Outcome.FULL;
    }
    if (known != null && head.number() <= known.head().number()) {
      boolean isSame =
          head.number() < known.head().number() || head.hash().equals(known.head().hash());
      return isSame ? Outcome.KNOWN : Outcome.CONTRADICTION;
    }
    Map<Key, KeptHead> all = new TreeMap<>(heads);
    all.put(key(fresh), fresh);
    write(all);
    heads.put(key(fresh), fresh);
    return Outcome.KEPT;
  }

  @GuardedBy("this")
  private boolean isFull(Member member) {
    long own = heads.values().stream().filter(each -> each.member().equals(member)).count();
    return own >= MOST_STREAMS || heads.size() >= MOST_HEADS;
  }

  private void write(Map<Key, KeptHead> all) throws IOException {
    String lines =
        all.values().stream()
            .map(each -> HeadCodec.line(each) + "\n")
            .collect(Collectors.joining());
    disk.write(String.valueOf(file.getFileName()), lines.getBytes(StandardCharsets.UTF_8));
    PrivateFiles.closeToOthers(file);
  }

  /** All heads, ordered by member and stream. */
  public synchronized List<KeptHead> heads() {
    return List.copyOf(heads.values());
  }

  /**
   * Reads the heads of a store, also of one that another process uses.
   *
   * @throws IOException if it cannot be read, or is no store of heads; the message names the line
   */
  public static List<KeptHead> read(Path file) throws IOException {
    return HeadCodec.read(file);
  }
}
