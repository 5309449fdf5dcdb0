package org.dfra.river.security.news;

import java.io.IOException;
import java.util.function.Supplier;
import org.dfra.core.audit.HeadStore;

/** This process's part of {@link TeamNews}. */
final class NewsService implements TeamNews {

  private final NewsFiles files;
  private final HeadFiles heads;
  private final Supplier<Numbers> numbers;

  /**
   * @param numbers what is in force in this process
   */
  NewsService(NewsFiles files, HeadFiles heads, Supplier<Numbers> numbers) {
    this.files = files;
    this.heads = heads;
    this.numbers = numbers;
  }

  @Override
  public Numbers numbers() {
    return numbers.get();
  }

  @Override
  public byte[] revocations() throws IOException {
    return files.revocations();
  }

  @Override
  public SignedPolicy policy() throws IOException {
    return files.policy();
  }

  @Override
  public void takeRevocations(byte[] list) throws IOException {
    files.storeRevocations(list);
  }

  @Override
  public void takePolicy(SignedPolicy policy) throws IOException {
    files.storePolicy(policy);
  }

  @Override
  public SignedHeads exchangeHeads(SignedHeads own) throws IOException {
    heads.take(own);
    return heads.own();
  }

  @Override
  public byte[] keptHeads(String member) throws IOException {
    return HeadStore.text(heads.kept(member));
  }
}
