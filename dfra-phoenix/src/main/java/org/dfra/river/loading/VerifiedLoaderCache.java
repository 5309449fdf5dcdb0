package org.dfra.river.loading;

import java.io.IOException;
import java.lang.ref.SoftReference;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The loaders of the verified codebases: one for each list of digests and parent, so that equal
 * code has one loader, from whichever peer it comes. Verified bytes stay accepted in this virtual
 * machine.
 */
final class VerifiedLoaderCache {

  private static final Logger LOG = LoggerFactory.getLogger(VerifiedLoaderCache.class);

  private final CodebaseVerifier admission;
  private final RefusalCache refusals;
  private final Map<ClassLoader, Map<List<String>, SoftReference<VerifiedLoader>>> loaders =
      new WeakHashMap<>(); // guarded by itself
  private final Map<DownloadKey, FutureTask<VerifiedLoader>> underWay = new ConcurrentHashMap<>();

  /**
   * @param nanoTime a clock in nanoseconds, for the age of refusals
   */
  VerifiedLoaderCache(CodebaseVerifier admission, LongSupplier nanoTime) {
    this.admission = admission;
    this.refusals = new RefusalCache(nanoTime);
  }

  /** The key by which equal requests share one download. */
  private record DownloadKey(
      List<CodebaseUrl> urls, List<@Nullable String> byDigest, ClassLoader parent) {}

  /**
   * The loader of a codebase.
   *
   * @throws CodeRefusedException if it is not trusted
   * @throws IOException if it cannot be fetched
   */
  ClassLoader loader(String codebase, ClassLoader parent) throws IOException {
    List<CodebaseUrl> urls;
    try {
      urls = CodebaseUrl.parse(codebase);
    } catch (CodeRefusedException e) {
      if (refusals.add(codebase, e)) {
        LOG.warn("{}", e.getMessage());
      }
      throw e;
    }
    List<String> digests = urls.stream().map(CodebaseUrl::digest).toList();
    VerifiedLoader known = known(digests, parent);
    if (known != null) {
      return known;
    }
    List<@Nullable String> byDigest = new ArrayList<>();
    urls.forEach(url -> byDigest.add(admission.digestTrustReason(url)));
    if (byDigest.contains(null)) {
      refusals.check(codebase);
    }
    return fetch(new DownloadKey(urls, byDigest, parent), codebase);
  }

  private @Nullable VerifiedLoader known(List<String> digests, ClassLoader parent) {
    for (ClassLoader at = parent; at != null; at = at.getParent()) {
      if (at instanceof VerifiedLoader verified && verified.digests().equals(digests)) {
        return verified;
      }
    }
    synchronized (loaders) {
      SoftReference<VerifiedLoader> kept = loaders.getOrDefault(parent, Map.of()).get(digests);
      return kept == null ? null : kept.get();
    }
  }

  private VerifiedLoader fetch(DownloadKey wanted, String codebase) throws IOException {
    FutureTask<VerifiedLoader> mine = new FutureTask<>(() -> make(wanted, codebase));
    FutureTask<VerifiedLoader> other = underWay.putIfAbsent(wanted, mine);
    if (other == null) {
      try {
        mine.run();
      } finally {
        underWay.remove(wanted, mine);
      }
    }
    try {
      return (other == null ? mine : other).get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while " + codebase + " was fetched", e);
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof CodeRefusedException refused) {
        if (refusals.add(codebase, refused)) {
          LOG.warn("{}", refused.getMessage());
        }
        throw refused;
      }
      if (cause instanceof IOException unreachable) {
        throw unreachable;
      }
      throw new IOException("codebase " + codebase + " cannot be loaded", cause);
    }
  }

  private VerifiedLoader make(DownloadKey wanted, String codebase) throws IOException {
    List<String> digests = wanted.urls().stream().map(CodebaseUrl::digest).toList();
    List<VerifiedJar> jars = admission.fetch(wanted.urls(), wanted.byDigest());
    synchronized (loaders) {
      VerifiedLoader meanwhile = known(digests, wanted.parent());
      if (meanwhile != null) {
        return meanwhile;
      }
      VerifiedLoader loader = new VerifiedLoader(codebase, digests, jars, wanted.parent());
      loaders
          .computeIfAbsent(wanted.parent(), parent -> new HashMap<>())
          .put(digests, new SoftReference<>(loader));
      return loader;
    }
  }
}
