// What a session keeps, and what leaves first.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "cache.hpp"
#include "factor_room.hpp"
#include "solve/lower_triangle.hpp"

namespace polylap {
namespace {

std::int64_t size_of(const std::string& text) {
    return static_cast<std::int64_t>(text.size());
}

struct Shelf {
    Cache<int, std::string, 3, size_of> cache{10};
    int made = 0;

    std::string get(int key, std::string value) {
        const auto made_it = [&]() -> Result<std::string> {
            ++made;
            return value;
        };
        return **cache.get(key, made_it);
    }
    /// Whether it is still there.
    bool has(int key) {
        const int before = made;
        get(key, "");
        return made == before;
    }
};

TEST(Cache, KeepsTheLastValues) {
    Shelf shelf;
    for (const int key : {1, 2, 3})
        EXPECT_EQ(shelf.get(key, "a"), "a");
    EXPECT_EQ(shelf.get(1, "other"), "a");
    EXPECT_EQ(shelf.made, 3);
    shelf.get(4, "a");
    EXPECT_TRUE(shelf.has(4));
    EXPECT_TRUE(shelf.has(1));
    EXPECT_TRUE(shelf.has(3));
    EXPECT_FALSE(shelf.has(2)) << "used longest ago";
}

TEST(Cache, KeepsSoManyBytesButTheLastValueWhateverItTakes) {
    Shelf shelf;
    shelf.get(1, "four");
    shelf.get(2, "six...");
    EXPECT_TRUE(shelf.has(2));
    EXPECT_TRUE(shelf.has(1)) << "ten bytes are not too many";
    shelf.get(3, "1");
    EXPECT_TRUE(shelf.has(3));
    EXPECT_FALSE(shelf.has(2));
    EXPECT_EQ(shelf.get(5, "a dozen byte"), "a dozen byte");
    EXPECT_TRUE(shelf.has(5));
    EXPECT_FALSE(shelf.has(3));
}

TEST(Cache, HandsOutAndForgets) {
    Shelf shelf;
    EXPECT_EQ(shelf.cache.take(1), nullptr);
    shelf.get(1, "one");
    const auto taken = shelf.cache.take(1);
    ASSERT_NE(taken, nullptr);
    EXPECT_EQ(*taken, "one");
    EXPECT_EQ(shelf.cache.take(1), nullptr);
}

TEST(Cache, KeepsNoErrors) {
    Cache<int, std::string, 3, size_of> cache{10};
    const auto fails = []() -> Result<std::string> { return Error{ErrorCode::cancelled, "cancelled"}; };
    EXPECT_FALSE(cache.get(1, fails).ok());
    EXPECT_EQ(cache.take(1), nullptr);
}

TEST(FactorRoom, TheOldestGoesFirst) {
    const std::array<KeptFactor, 4> factors{{{100, 3}, {0, 1}, {100, 2}, {50, 4}}};
    EXPECT_EQ(factor_to_drop(factors, 1, 350), std::nullopt) << "250 and 100 more";
    EXPECT_EQ(factor_to_drop(factors, 1, 349), 2U);
    EXPECT_EQ(factor_to_drop(factors, 2, 250), std::nullopt) << "its own is replaced";
    EXPECT_EQ(factor_to_drop(factors, 2, 249), 0U);
    const std::array<KeptFactor, 2> alone{{{100, 1}, {0, 0}}};
    EXPECT_EQ(factor_to_drop(alone, 0, 10), std::nullopt) << "nothing but its own";
    EXPECT_EQ(factor_to_drop(alone, 1, 10), 0U);
}

TEST(LowerTriangle, IsWhatEigenSays) {
    SparseMatrix a(4, 4);
    const std::array<Eigen::Triplet<double, Index>, 6> entries{
        {{0, 0, 1}, {2, 0, 2}, {0, 2, 3}, {1, 2, 4}, {3, 2, 5}, {3, 3, 6}}};
    a.setFromTriplets(entries.begin(), entries.end());
    const SparseMatrix lower = lower_triangle(a);
    EXPECT_TRUE(lower.isCompressed());
    EXPECT_EQ(lower.nonZeros(), 4);
    EXPECT_EQ(Matrix(lower), Matrix(SparseMatrix(a.triangularView<Eigen::Lower>())));
    EXPECT_EQ(lower_triangle(SparseMatrix(0, 0)).nonZeros(), 0);
}

}  // namespace
}  // namespace polylap
