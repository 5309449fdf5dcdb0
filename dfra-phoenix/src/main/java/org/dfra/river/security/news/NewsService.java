package org.dfra.river.security.news;

import java.io.IOException;
import java.util.function.Supplier;

/** This process's part of {@link TeamNews}. */
final class NewsService implements TeamNews {

  private final NewsFiles files;
  private final Supplier<Numbers> numbers;

  /**
   * @param numbers what is in force in this process
   */
  NewsService(NewsFiles files, Supplier<Numbers> numbers) {
    this.files = files;
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
}
