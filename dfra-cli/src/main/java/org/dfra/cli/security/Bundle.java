package org.dfra.cli.security;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;

/**
 * What a member gets from its authority: a zip with files whose names {@link SecurityFiles} has.
 * The two key stores in it are encrypted under the one-time passphrase; all else is public.
 */
public final class Bundle {

  /** The end of a bundle's name. */
  public static final String SUFFIX = ".bundle";

  private static final List<String> REQUIRED =
      List.of(SecurityFiles.IDENTITY, SecurityFiles.AUTHORITY, SecurityFiles.REVOKED);
  private static final Set<String> ALLOWED =
      Set.of(
          SecurityFiles.IDENTITY,
          SecurityFiles.ROBOT,
          SecurityFiles.AUTHORITY,
          SecurityFiles.REVOKED,
          SecurityFiles.POLICY,
          SecurityFiles.POLICY_SIGNATURE);

  private static final int MAX_BYTES = 6 * 1024 * 1024;
  private static final String REMEDY = "; ask for a new bundle";

  private final Map<String, byte[]> files; // by their names

  private Bundle(Map<String, byte[]> files) {
    this.files = Collections.unmodifiableMap(new TreeMap<>(files));
  }

  /**
   * A bundle of files.
   *
   * @throws IllegalArgumentException if there is one that no bundle has, or one is missing
   */
  public static Bundle of(Map<String, byte[]> files) {
    if (!ALLOWED.containsAll(files.keySet()) || !files.keySet().containsAll(REQUIRED)) {
      throw new IllegalArgumentException("a bundle with the files " + files.keySet());
    }
    return new Bundle(files);
  }

  /**
   * Reads a bundle. At most 6 MiB of the file are read, and of each file in it what {@link
   * SecurityFiles#maxBytes} permits.
   *
   * @throws IdentityException if it is no bundle, or has a file that no bundle has
   */
  public static Bundle read(Path file) throws IdentityException {
    byte[] bytes = bytes(file);
    Map<String, byte[]> files = new TreeMap<>();
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(bytes))) {
      for (ZipEntry each = zip.getNextEntry(); each != null; each = zip.getNextEntry()) {
        add(each.getName(), zip, file, files);
      }
    } catch (IOException | IllegalArgumentException e) { // also of names that are no text
      throw new IdentityException(
          file + " is no whole bundle (" + e.getMessage() + "); copy it again", e);
    }
    for (String each : REQUIRED) {
      if (!files.containsKey(each)) {
        throw new IdentityException(
            file + " is no bundle of a member, since it has no " + each + REMEDY);
      }
    }
    if (files.containsKey(SecurityFiles.POLICY)
        != files.containsKey(SecurityFiles.POLICY_SIGNATURE)) {
      throw new IdentityException(
          file
              + " has only one of "
              + SecurityFiles.POLICY
              + " and "
              + SecurityFiles.POLICY_SIGNATURE
              + REMEDY);
    }
    return new Bundle(files);
  }

  private static byte[] bytes(Path file) throws IdentityException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(MAX_BYTES + 1);
      if (bytes.length > MAX_BYTES) {
        throw new IdentityException(
            file + " has more than " + MAX_BYTES + " bytes, so it is no bundle" + REMEDY);
      }
      return bytes;
    } catch (NoSuchFileException e) {
      throw new IdentityException("there is no file " + file + "; name a bundle", e);
    } catch (IOException e) {
      throw new IdentityException(file + " cannot be read (" + e + ")", e);
    }
  }

  private static void add(String name, ZipInputStream zip, Path file, Map<String, byte[]> files)
      throws IOException, IdentityException {
    if (!ALLOWED.contains(name)) {
      throw new IdentityException(
          file + " has a file \"" + name + "\", which no bundle has" + REMEDY);
    }
    int most = SecurityFiles.maxBytes(name);
    byte[] content = zip.readNBytes(most + 1);
    if (content.length > most) {
      throw new IdentityException(
          file + ": its " + name + " has more than " + most + " bytes" + REMEDY);
    }
    if (files.put(name, content) != null) {
      throw new IdentityException(file + " has " + name + " twice" + REMEDY);
    }
  }

  /** A file of it; empty if it has none of this name. */
  public Optional<byte[]> file(String name) {
    return Optional.ofNullable(files.get(name)).map(byte[]::clone);
  }

  /**
   * A file that every bundle has.
   *
   * @throws IllegalArgumentException if not every bundle has it
   */
  byte[] required(String name) {
    return file(name).orElseThrow(() -> new IllegalArgumentException(name));
  }

  /** The bytes of the zip. */
  public byte[] toBytes() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      for (Map.Entry<String, byte[]> each : files.entrySet()) {
        zip.putNextEntry(new ZipEntry(each.getKey()));
        zip.write(each.getValue());
        zip.closeEntry();
      }
    } catch (IOException e) {
      throw new IllegalStateException("memory is written to without failure", e);
    }
    return bytes.toByteArray();
  }
}
